// SPDX-License-Identifier: MIT
// The parts of figures and pages.
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/well_formed.h"
#include "workbench/experiments/charts/interval_strip.h"
#include "workbench/experiments/charts/markup.h"
#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/charts/scale.h"

namespace reorient {
namespace {

TEST(Markup, EscapesText) {
  EXPECT_EQ(escaped("<script>alert('a' & \"b\")</script>"),
            "&lt;script&gt;alert(&#39;a&#39; &amp; &quot;b&quot;)&lt;/script&gt;");
  EXPECT_EQ(escaped("a\x01\xFF\n\tb\x7F"), "a\\x01\\xFF  b\\x7F");
  EXPECT_EQ(escaped("\u00fcber \u2013"), "\u00fcber \u2013");
}

RC_GTEST_PROP(MarkupProperty, IsWellFormedForAnyText, (const std::string& text, const std::string& value)) {
  Markup out;
  {
    const Element paragraph(out, "p", {{"class", value}});
    out.leaf("b", text);
    out.text(text);
    out.single("br", {{"title", value}});
  }
  RC_ASSERT(mistake_in_markup(out.str()).empty());
}

TEST(WellFormed, FindsMistakes) {
  EXPECT_EQ(mistake_in_markup("<p class=\"a\">b &amp; c<br/></p>\n"), "");
  for (const char* wrong :
       {"<p>", "</p>", "<p><b></p></b>", "a & b", "<p class=a></p>", "<p a=\"<\"></p>", "a\x01", "\xFF"})
    EXPECT_NE(mistake_in_markup(wrong), "") << wrong;
}

TEST(Numbers, AreShortAndTheSameEverywhere) {
  EXPECT_EQ(fixed(2.25, 1), "2.2");
  EXPECT_EQ(fixed(-0.01, 1), "0.0") << "a zero has no sign";
  EXPECT_EQ(fixed(1e308, 0).size(), 309U);
  EXPECT_EQ(fixed(std::nan(""), 1), "\u2013");
  EXPECT_EQ(fixed(Interval{0.0, INFINITY}, 1), "[0.0, \u2013]");
  EXPECT_EQ(percent(0.305), "30 %");
  EXPECT_EQ(p_value(0.0004), "< 0.001");
  EXPECT_EQ(p_value(0.0312), "0.031");
}

TEST(Scale, HasRoundTicks) {
  EXPECT_EQ(ticks(0.0, 1.0, 5), (std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
  EXPECT_EQ(ticks(3.0, 26.0, 4), (std::vector<double>{10.0, 20.0}));
  EXPECT_EQ(logarithmic_ticks(0.7, 60.0), (std::vector<double>{1.0, 2.0, 5.0, 10.0, 20.0, 50.0}));
  EXPECT_EQ(logarithmic_ticks(0.3, 3600.0), (std::vector<double>{1.0, 10.0, 100.0, 1000.0}));
  EXPECT_EQ(tick_digits({0.0, 0.5, 1.0}), 1);
  EXPECT_EQ(tick_digits({0.0, 10.0}), 0);
  EXPECT_EQ(round_up_to_tick(73.0, 4), 80.0);
}

RC_GTEST_PROP(ScaleProperty, KeepsItsTicksWithinBoundsAndFew, ()) {
  const double low = *rc::gen::inRange(-1000, 1000) / 7.0;
  const double high = low + *rc::gen::inRange(1, 100'000) / 13.0;
  const int wanted = *rc::gen::inRange(2, 9);
  const std::vector<double> all = ticks(low, high, wanted);
  const double slack = 1e-6 * (high - low);
  RC_ASSERT(all.size() <= static_cast<std::size_t>(wanted) + 1U);
  for (const double tick : all) RC_ASSERT(tick >= low - slack && tick <= high + slack);
}

TEST(Scale, GoesFromItsFirstPlaceToItsLast) {
  const Scale backwards{0.0, 10.0, 100.0, 0.0};
  EXPECT_EQ(backwards(0.0), 100.0);
  EXPECT_EQ(backwards(10.0), 0.0);
  const Scale logarithmic{1.0, 100.0, 0.0, 50.0, true};
  EXPECT_NEAR(logarithmic(10.0), 25.0, 1e-9);
}

TEST(Plot, CutsOffWhatLiesBeyondItsAxes) {
  Markup out;
  {
    Plot plot(out, "a <line>", {"x & y", 0.0, 1.0}, {"z", 0.0, 1.0});
    plot.line({{-5.0, 0.5}, {0.5, 7.0}, {9.0, 0.5}}, "s0");
    plot.stretch(0.9, 30.0, "wrong");
  }
  EXPECT_EQ(mistake_in_markup(out.str()), "");
  EXPECT_NE(out.str().find("points=\"46.0,91.0 188.0,12.0 330.0,91.0\""), std::string::npos) << out.str();
}

TEST(Scale, IsLogarithmicAtBothEndsAndLinearAroundZero) {
  const Scale scale{-300.0, 300.0, 0.0, 100.0, false, 3.0};
  EXPECT_NEAR(scale(0.0), 50.0, 1e-9);
  EXPECT_NEAR(scale(-300.0), 0.0, 1e-9);
  EXPECT_NEAR(scale(300.0), 100.0, 1e-9);
  EXPECT_NEAR(scale(20.0) + scale(-20.0), 100.0, 1e-9);
  EXPECT_GT(scale(5.5) - scale(0.0), 10.0) << "a decision is visible beside much evidence";
  EXPECT_NEAR(scale(0.2) - scale(0.0), 2.0 * (scale(0.1) - scale(0.0)), 0.01);
}

TEST(SignedTicks, ArePowersOfTenWithinTheBounds) {
  EXPECT_EQ(signed_ticks(-150.0, 150.0), (std::vector<double>{-100.0, -10.0, 0.0, 10.0, 100.0}));
  EXPECT_EQ(signed_ticks(-5.0, 15.0), (std::vector<double>{0.0, 10.0}));
  EXPECT_EQ(signed_ticks(-1.0, 1.0), (std::vector<double>{0.0}));
}

TEST(Plot, HoldsAValueUntilTheNextStep) {
  const std::vector<PlotPoint> steps = as_steps({{0.0, 0.0}, {2.0, 0.5}}, 9.0);
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[1].x, 2.0);
  EXPECT_EQ(steps[1].y, 0.0);
  EXPECT_EQ(steps[3].x, 9.0);
  EXPECT_EQ(steps[3].y, 0.5);
}

TEST(IntervalStrip, ShowsThatAnIntervalExceedsTheAxis) {
  const auto drawn = [](double high) {
    Markup out;
    draw_interval(out, "", {"", 0.0, 1.0}, 0.5, {0.25, high}, "s0");
    EXPECT_EQ(mistake_in_markup(out.str()), "");
    return out.str();
  };
  EXPECT_EQ(drawn(0.75).find("polyline"), std::string::npos);
  EXPECT_NE(drawn(1.5).find("polyline"), std::string::npos);
  EXPECT_NE(drawn(INFINITY).find("polyline"), std::string::npos);
}

}  // namespace
}  // namespace reorient
