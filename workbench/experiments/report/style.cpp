#include "workbench/experiments/report/style.h"

namespace reorient {

std::string_view report_style() {
  return R"css(
:root {
  color-scheme: light dark;
  --paper: #fdfdfb; --ink: #1c1e21; --soft: #5c6168; --rule: #d5d7d3; --faint: #f0f1ed; --wrong: #d9d9d3;
  --c0: #0072b2; --c1: #c84e00; --c2: #00815e; --c3: #a8568a; --c4: #b07d00; --c5: #2f8fc4; --c6: #55585c; --c7: #b3243a;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #15171a; --ink: #e4e5e2; --soft: #a0a5ab; --rule: #3a3e43; --faint: #1f2226; --wrong: #373b40;
    --c0: #56a8e8; --c1: #f08a4b; --c2: #35c79b; --c3: #dd95c2; --c4: #e3b341; --c5: #8fd0f5; --c6: #b9bdc2; --c7: #f27a8a;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body {
  margin: 0 auto; max-width: 72rem; padding: 2.5rem 1.5rem 4rem;
  background: var(--paper); color: var(--ink);
  font: 1rem/1.55 Charter, "Bitstream Charter", "Iowan Old Style", "Source Serif 4", Georgia, "DejaVu Serif", serif;
  counter-reset: figure table;
}
header { border-bottom: 1px solid var(--rule); padding-bottom: 1.5rem; }
.kicker { margin: 0; color: var(--soft); font: 0.8rem/1.4 system-ui, sans-serif; letter-spacing: 0.06em; }
h1 { margin: 0.4rem 0 0.8rem; max-width: 46rem; font-size: 1.9rem; line-height: 1.2; font-weight: 600; text-wrap: balance; }
h2 { margin: 3rem 0 0.6rem; font-size: 1.25rem; line-height: 1.3; font-weight: 600; }
p, ul.notes { max-width: 46rem; }
p { margin: 0.6rem 0; overflow-wrap: anywhere; }
a { color: var(--c0); }
code { font: 0.82em/1.45 ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.15rem 1.2rem; margin: 1.2rem 0 0; font: 0.85rem/1.5 system-ui, sans-serif; }
dt { color: var(--soft); }
dd { margin: 0; min-width: 0; overflow-wrap: anywhere; }
ul.notes { padding-left: 1.1rem; }
ul.notes li { margin: 0.35rem 0; }

.scroll { overflow-x: auto; margin: 0 0 1.6rem; }
table { border-collapse: collapse; font: 0.83rem/1.4 system-ui, sans-serif; font-variant-numeric: tabular-nums lining-nums; }
table.numbers { min-width: 100%; border-bottom: 1.5px solid var(--ink); }
.caption { margin: 1.2rem 0 0.6rem; max-width: 58rem; color: var(--soft); font: 0.83rem/1.5 system-ui, sans-serif; }
.caption::before { counter-increment: table; content: "Table " counter(table) ". "; color: var(--ink); font-weight: 600; }
th, td { padding: 0.3rem 0.6rem; text-align: right; vertical-align: baseline; font-weight: 400; white-space: nowrap; }
th.name { text-align: left; white-space: normal; min-width: 4rem; }
thead th { color: var(--soft); border-top: 1.5px solid var(--ink); border-bottom: 1px solid var(--ink); vertical-align: bottom; }
tr.group th, tr.group td { border-top: 1px solid var(--rule); }
tr.own th, tr.own td { background: var(--faint); }
th:first-child, td:first-child { padding-left: 0.2rem; }
th:last-child, td:last-child { padding-right: 0.2rem; }

figure { margin: 1.6rem 0 2.4rem; }
figcaption { margin-top: 0.7rem; max-width: 58rem; color: var(--soft); font: 0.83rem/1.5 system-ui, sans-serif; }
figcaption::before { counter-increment: figure; content: "Figure " counter(figure) ". "; color: var(--ink); font-weight: 600; }
.made { display: block; margin-top: 0.35rem; font-size: 0.72rem; overflow-wrap: anywhere; }
.panels { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(19rem, 100%), 1fr)); gap: 1.4rem 1.6rem; }
.panel { min-width: 0; max-width: 24rem; }
.panel-name { margin: 0 0 0.2rem; font: 600 0.83rem/1.4 system-ui, sans-serif; }
.panel-name strong { text-transform: capitalize; }
.reading, .again { margin: 0.2rem 0 0; color: var(--soft); font: 0.78rem/1.45 system-ui, sans-serif; font-variant-numeric: tabular-nums; }
.again { font-size: 0.72rem; }
.legend { display: flex; flex-wrap: wrap; gap: 0.2rem 1.4rem; margin: 0 0 0.7rem; padding: 0; list-style: none; font: 0.83rem/1.4 system-ui, sans-serif; }
.legend li { display: flex; align-items: center; gap: 0.5rem; }
.swatch { width: 30px; height: 10px; flex: none; }

table.strips th, table.strips td { padding: 0.05rem 0.7rem 0.05rem 0; text-align: left; vertical-align: middle; }
table.strips thead th { border: none; padding-bottom: 0.4rem; }
table.strips thead .strip-cell { text-align: center; }

svg { display: block; overflow: visible; }
.plot { width: 100%; height: auto; }
.strip { width: 300px; height: auto; }
svg text { fill: var(--soft); font: 10.5px system-ui, sans-serif; font-variant-numeric: tabular-nums; }
.middle { text-anchor: middle; }
.end { text-anchor: end; }
.grid { stroke: var(--rule); stroke-width: 0.7; }
.axis { stroke: var(--soft); stroke-width: 1; }
.moment { stroke: var(--ink); stroke-width: 1; }
.wrong { fill: var(--wrong); }
.chance { fill: none; stroke: var(--soft); stroke-width: 1; stroke-dasharray: 1.5 3; }
.s0 { --c: var(--c0); --dash: none; }
.s1 { --c: var(--c1); --dash: 7 3; }
.s2 { --c: var(--c2); --dash: 2 2.5; }
.s3 { --c: var(--c3); --dash: 9 3 2 3; }
.s4 { --c: var(--c4); --dash: 4 2; }
.s5 { --c: var(--c5); --dash: 12 4; }
.s6 { --c: var(--c6); --dash: 1.5 4; }
.s7 { --c: var(--c7); --dash: 6 2 1.5 2; }
.line { fill: none; stroke: var(--c); stroke-width: 1.8; stroke-dasharray: var(--dash); stroke-linejoin: round; }
.line.chance { --c: var(--soft); --dash: 1.5 3; stroke-width: 1; }
.line.solid { stroke-dasharray: none; }
.band { fill: var(--c); opacity: 0.13; }
.whisker { stroke: var(--c); stroke-width: 2.2; stroke-linecap: round; }
.dot { fill: var(--c); stroke: var(--paper); stroke-width: 1; }
footer { margin-top: 3rem; padding-top: 1rem; border-top: 1px solid var(--rule); color: var(--soft); font: 0.78rem/1.5 system-ui, sans-serif; }

@media (max-width: 40rem) {
  body { padding: 1.2rem 1rem 3rem; }
  h1 { font-size: 1.45rem; }
  dl { grid-template-columns: 1fr; gap: 0; }
  dd { margin-bottom: 0.5rem; }
  .strip { width: 150px; }
  .strip text { font-size: 20px; }
  table.strips th, table.strips td { padding-right: 0.4rem; }
  table.strips .reading { white-space: normal; min-width: 6.5rem; }
}
@media print {
  @page { size: A4; margin: 16mm 14mm; }
  :root {
    color-scheme: light;
    --paper: #ffffff; --ink: #000000; --soft: #44484d; --rule: #c8cac6; --faint: #f2f2ef; --wrong: #dcdcd6;
    --c0: #0072b2; --c1: #c84e00; --c2: #00815e; --c3: #a8568a; --c4: #b07d00; --c5: #2f8fc4; --c6: #55585c; --c7: #b3243a;
  }
  html { font-size: 11.5px; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  body { max-width: none; padding: 0; }
  .scroll { overflow: visible; }
  table.numbers { font-size: 0.74rem; }
  th, td { padding: 0.22rem 0.35rem; }
  table.numbers th, table.numbers td { white-space: normal; }
  thead { display: table-header-group; }
  tr, .panel, figure, figcaption { break-inside: avoid; }
  .caption, .legend { break-after: avoid; }
  h2 { break-after: avoid; margin-top: 1.6rem; }
  .panels { grid-template-columns: repeat(3, 1fr); gap: 0.8rem 1rem; }
  a { color: inherit; text-decoration: none; }
}
)css";
}

}  // namespace reorient
