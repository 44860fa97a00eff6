// SPDX-License-Identifier: MIT
// What behaviors read: any value by its name. Pinned values stay at the top.
import { useState } from "preact/hooks";

import { plain } from "../format.js";
import { store } from "../robot.js";
import { SearchBox } from "../search_box.jsx";
import { set, settings } from "../settings.js";
import { useChanges } from "../ticker.js";

/// All values as [name, value], such as ["pose.x", 0.5].
function valuesOf(value, prefix = "") {
  if (value === null || typeof value !== "object") return [[prefix, value]];
  return Object.entries(value).flatMap(([name, inner]) => valuesOf(inner, prefix ? `${prefix}.${name}` : name));
}

function Row({ name, value, isPinned }) {
  const toggle = () =>
    set({ pinned: isPinned ? settings.pinned.filter((it) => it !== name) : [...settings.pinned, name] });
  return (
    <tr class={isPinned ? "pinned" : ""}>
      <td>
        <button
          class="plain pin"
          aria-pressed={isPinned}
          aria-label={`Pin ${name}`}
          title={isPinned ? "Unpin" : "Pin"}
          onClick={toggle}
        >
          {isPinned ? "★" : "☆"}
        </button>
      </td>
      <td>
        <code>{name}</code>
      </td>
      <td class="value">{plain(value)}</td>
    </tr>
  );
}

function World() {
  useChanges(150);
  const [search, setSearch] = useState("");
  const found = store.read("/world");
  if (!found) return <p class="empty">The robot has not sent its world yet.</p>;
  const request = store.read("/request");
  const costs = store.read("/costs");
  const all = [
    ...valuesOf(found.value),
    ...(request ? valuesOf(request.value, "request") : []),
    ...(costs ? valuesOf({ frame: costs.value.frame_milliseconds, ...costs.value.milliseconds }, "milliseconds") : []),
  ];
  const byName = new Map(all);
  const text = search.toLowerCase();
  return (
    <div class="fill column">
      <div class="row pad">
        <SearchBox
          placeholder="Search a name, such as pose."
          label="Search values of the world"
          value={search}
          onSearch={setSearch}
        />
      </div>
      <div class="scroll">
        <table class="values">
          <tbody>
            {settings.pinned.map((name) => (
              <Row key={`pin ${name}`} name={name} value={byName.get(name)} isPinned />
            ))}
          </tbody>
          <tbody>
            {all
              .filter(([name]) => name.toLowerCase().includes(text) && !settings.pinned.includes(name))
              .map(([name, value]) => (
                <Row key={name} name={name} value={value} isPinned={false} />
              ))}
          </tbody>
        </table>
      </div>
    </div>
  );
}

export default { id: "world", title: "World", area: "right", key: "6", Component: World };
