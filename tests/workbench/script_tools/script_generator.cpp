// SPDX-License-Identifier: MIT
#include "tests/workbench/script_tools/script_generator.h"

#include <span>
#include <vector>

#include "engine/script/language/world_fields.h"
#include "geometry/random.h"

namespace reorient {
namespace {

using Type = WorldField::Type;

/// Idioms that a check without knowledge of types would report as mistakes. `N` is replaced by a unique number. Each
/// idiom defines a local function fN that returns a number for any argument.
constexpr const char* kIdioms[] = {
    "local function fN(x, y) return (tonumber(x) or 1) + (y and y * 2 or 0) end",
    "local function fN(x) x = tonumber(x) or 0 return x + 1 end",
    "local function fN(kind, x) if type(kind) ~= 'table' then return 1 end return kind.value + x end",
    "local function fN(...) local n = select('#', ...) for _, v in ipairs { ... } do if v == 'x' then n = n + 1 end "
    "end "
    "return n end",
    "local ClassN = {} ClassN.__index = ClassN function ClassN.new(x) return setmetatable({ x = x }, ClassN) end "
    "function ClassN:get() return self.x or 0 end local function fN(x) return ClassN.new(tonumber(x)):get() end",
    "local vectorN = setmetatable({}, { __add = function() return { x = 2 } end, __call = function(_, a) return a end "
    "}) "
    "local function fN() return (vectorN + 1).x + vectorN(3) end",
    "local sumN sumN = function(n) return n > 0 and n + sumN(n - 1) or 0 end local function fN() return sumN(3) end",
    "local tableN = { first = 1 } for _, key in ipairs { 'second', 'third' } do tableN[key] = 2 end "
    "local function fN() return tableN.first + tableN.second + tableN.third end",
    "local listN = { 3, 1, 2 } table.sort(listN) local function fN() return #listN + listN[1] end",
    "local countN = 0 local function fN() countN = countN + 1 return countN end",
    "local mixedN = 1 local function fN(x) mixedN = x == 1 and 'one' or 2 return #tostring(mixedN) end",
    "local function pairN() return 0.1, 0.2 end local function fN() local a, b = pairN() return math.max(pairN()) + a "
    "+ b "
    "end",
    "local function fN(x) local ok, result = pcall(function() return x.y.z end) return ok and result and 1 or 2 end",
    "local textN = ('%s-%d'):format('a', 3) local function fN() return #textN:upper():rep(2) + textN:len() end",
    "local function fN(x) repeat local done = true until done goto over do return 0 end ::over:: return #[[ text ]] "
    "end",
    "local lookupN = { upright = 1, lying = 2 } local function fN() return lookupN[robot.posture] or lookupN.upright "
    "end",
    "local function fN(first) local function inner() return first and 1 or 0 end return inner() end",
    "local onceN local function fN() onceN = onceN or { n = 1 } return onceN.n end",
    "local function optionN(o) o = o or {} return o.size or 2 end local function fN() return optionN() + optionN { "
    "size = 1 } "
    "end",
    "local robotN = { posture = 5 } local function fN() local robot = robotN return robot.posture + 1 end",
    "local function maybeN() if robot.penalized then return nil end return 4 end local function fN() local m = "
    "maybeN() "
    "return m and m + 1 or 0 end",
    "local copyN = {} for key, value in pairs({ a = 1, b = 2 }) do copyN[key] = value end local function fN() return "
    "copyN.a "
    "+ copyN.b end",
    "local chooseN = robot ~= nil and math.min or math.max local function fN() return chooseN(1, 2) end",
    "local function fN() local t <const> = table.pack(1, nil, 3) return t.n + select(-1, table.unpack(t, 1, t.n)) end",
};

class Generator {
 public:
  explicit Generator(std::uint64_t number) : number_(number), random_(number) {}

  std::string run() {
    text_ = "--- Generated at random.\n";
    write_parameters();
    text_ += "local memory = keep { count = 0, last = 0.0, word = \"none\", seen = false }\n";
    const std::uint64_t idioms = 1 + random_.below(4);
    for (std::uint64_t i = 0; i < idioms; ++i) write_idiom();
    text_ += "local function bounded(x, most) return math.max(-most, math.min(most, x)) end\n";
    const std::uint64_t functions = 1 + random_.below(4);
    for (std::uint64_t i = 0; i < functions; ++i) write_function();
    write_machine();
    return text_;
  }

 private:
  std::uint64_t below(std::uint64_t count) { return random_.below(count); }
  bool chance(double share) { return random_.uniform() < share; }
  template <typename T>
  const T& any(const std::vector<T>& all) {
    return all[below(all.size())];
  }

  void write_parameters() {
    text_ += "local p = param {\n";
    const std::uint64_t count = 1 + below(3);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string name = "number_" + std::to_string(i);
      numbers_.push_back("p." + name);
      times_.push_back(name);
      text_ += "  " + (chance(0.2) ? "[\"" + name + "\"]" : name) + " = { " + std::to_string(below(5)) +
               ".5, range = { 0, 10 }, unit = \"s\", doc = \"a time\" },\n";
    }
    if (chance(0.5)) {
      text_ += "  whole = { 3, range = { 1, 9 }, integer = true, doc = \"a whole number\" },\n";
      numbers_.emplace_back("p.whole");
    }
    if (chance(0.5)) {
      text_ += "  switch = { true, doc = \"a switch\" },\n";
      booleans_.emplace_back("p.switch");
    }
    if (chance(0.5)) {
      text_ += "  mode = { \"slow\", choices = { \"slow\", \"fast\" }, doc = \"a choice\" },\n";
      strings_.emplace_back("p.mode");
    }
    text_ += "}\n";
  }

  void write_idiom() {
    std::string idiom = kIdioms[below(std::size(kIdioms))];
    const std::string own = std::to_string(++names_);
    for (std::size_t at = idiom.find('N'); at != std::string::npos; at = idiom.find('N', at + 1))
      idiom.replace(at, 1, own);
    text_ += idiom + "\n";
    const std::string name = "f" + own;
    const bool takes_none = idiom.find(name + "()") != std::string::npos;
    const bool takes_one =
        idiom.find(name + "(x)") != std::string::npos || idiom.find(name + "(first)") != std::string::npos;
    calls_.push_back(name + "()");
    if (takes_none) return;
    calls_.push_back(name + "(1)");
    calls_.push_back(name + "('x')");
    if (!takes_one) calls_.push_back(name + "(nil, 2)");
  }

  /// A field of the world of this type.
  std::string field(Type type) {
    const std::span<const WorldField> fields = world_fields();
    for (;;) {
      const WorldField& one = fields[below(fields.size())];
      if (one.type == type && one.replacement.empty()) return one.full_name();
    }
  }

  std::string number(int depth = 0) {
    const std::uint64_t kind = below(depth > 2 ? 4 : 10);
    if (kind == 0) return std::to_string(below(9)) + "." + std::to_string(below(9));
    if (kind == 1) return field(Type::number);
    if (kind == 2) return any(numbers_);
    if (kind == 3) return chance(0.5) ? "memory.count" : "memory.last";
    if (kind == 4) return any(calls_);
    if (kind == 5) return "math.abs(" + number(depth + 1) + ")";
    if (kind == 6) return "(" + boolean(depth + 1) + " and " + number(depth + 1) + " or " + number(depth + 1) + ")";
    if (kind == 7) return "-(" + number(depth + 1) + ")";
    if (kind == 8) return "#" + (chance(0.5) ? "(" + string(depth + 1) + ")" : "'text'");
    constexpr const char* kOperators[] = {" + ", " - ", " * ", " / "};
    return "(" + number(depth + 1) + kOperators[below(4)] + number(depth + 1) + ")";
  }

  std::string string(int depth = 0) {
    const std::uint64_t kind = below(depth > 2 ? 3 : 7);
    if (kind == 0) return "\"text " + std::to_string(below(9)) + "\"";
    if (kind == 1) return field(Type::name);
    if (kind == 2) return strings_.empty() ? "memory.word" : any(strings_);
    if (kind == 3) return "(" + string(depth + 1) + " .. " + number(depth + 1) + ")";
    if (kind == 4) return "string.format(\"%.1f %s\", " + number(depth + 1) + ", " + string(depth + 1) + ")";
    if (kind == 5) return "tostring(" + boolean(depth + 1) + ")";
    return "(" + string(depth + 1) + "):sub(1, 3)";
  }

  std::string boolean(int depth = 0) {
    const std::uint64_t kind = below(depth > 2 ? 3 : 8);
    if (kind == 0) return chance(0.5) ? "true" : "memory.seen";
    if (kind == 1) return booleans_.empty() ? field(Type::boolean) : any(booleans_);
    if (kind == 2) return "(robot.posture ~= \"lying\")";
    if (kind == 3) return "not " + boolean(depth + 1);
    if (kind == 4) return "(" + boolean(depth + 1) + (chance(0.5) ? " and " : " or ") + boolean(depth + 1) + ")";
    if (kind == 5) return "(memory.word == " + string(depth + 1) + ")";
    if (kind == 6) return "published.generated_flag";
    constexpr const char* kOperators[] = {" < ", " > ", " <= ", " >= ", " == ", " ~= "};
    return "(" + number(depth + 1) + kOperators[below(6)] + number(depth + 1) + ")";
  }

  /// A function of two numbers, the second of which is optional.
  void write_function() {
    const std::string name = "calculate_" + std::to_string(++names_);
    text_ += "local function " + name + "(x, y)\n  y = y or " + number() + "\n";
    if (chance(0.5)) text_ += "  if " + boolean() + " then return x + y end\n";
    if (chance(0.5)) text_ += "  local z = " + number() + "\n  for i = 1, 3 do z = z + i * x end\n  y = y + z\n";
    text_ += "  return x * y\nend\n";
    calls_.push_back(name + "(" + number() + ")");
    calls_.push_back(name + "(" + number() + ", " + number() + ")");
  }

  std::string statement(int depth = 0) {
    const std::uint64_t kind = below(depth > 1 ? 6 : 9);
    if (kind == 0) return "memory.count = bounded(" + number() + ", 9)";
    if (kind == 1) return "memory.word = (" + string() + "):sub(1, 20)";
    if (kind == 2) return "memory.seen, memory.last = " + boolean() + ", bounded(" + number() + ", 1e3)";
    if (kind == 3) return "head.look(bounded(" + number() + ", 1), 0.1" + (chance(0.5) ? ", 2.0)" : ")");
    if (kind == 4) return "walk.velocity(bounded(" + number() + ", 0.2), 0, 0)";
    if (kind == 5) return "local _ = " + (chance(0.5) ? string() : boolean());
    if (kind == 6)
      return "if " + boolean() + " then " + statement(depth + 1) + " else " + statement(depth + 1) + " end";
    if (kind == 7) return "for _, v in ipairs { 1, 2 } do memory.count = memory.count + v end";
    return "do " + statement(depth + 1) + " end";
  }

  std::string function(const char* body_of) {
    if (std::string(body_of) == "when") return "function() return " + boolean() + " end";
    std::string body = "function()";
    const std::uint64_t count = 1 + below(3);
    for (std::uint64_t i = 0; i < count; ++i) body += "\n      " + statement();
    if (std::string(body_of) == "enter" && chance(0.2)) body += "\n      command.pause_training()";
    if (chance(0.2)) body += "\n      log.info(" + string() + ")";
    return body + "\n    end";
  }

  std::string transition(const std::string& target) {
    std::string text = "    { \"" + target + "\"";
    const bool has_when = chance(0.7);
    if (has_when) text += ", when = " + function("when");
    if (has_when && chance(0.5)) text += ", lasting = " + time();
    if (!has_when || chance(0.2)) text += ", after = " + time();
    if (chance(0.7)) text += ", because = \"it was chosen at random\"";
    return text + " },\n";
  }

  std::string time() {
    if (chance(0.4)) return "0." + std::to_string(1 + below(9));
    return chance(0.5) ? "\"" + any(times_) + "\"" : "function() return 0.5 end";
  }

  /// States in a circle, each with a transition to the next one. Some of them contain states.
  std::string states(const std::string& prefix, int depth) {
    const std::uint64_t count = 2 + below(3);
    std::string text = "  initial = \"" + prefix + "0\",\n";
    for (std::uint64_t i = 0; i < count; ++i) {
      text += "  state \"" + prefix + std::to_string(i) + "\" {\n";
      for (const char* what : {"enter", "update", "exit"}) {
        if (chance(0.4)) text += std::string("    ") + what + " = " + function(what) + ",\n";
      }
      if (chance(0.2)) text += "    publishes = \"generated_flag\",\n";
      text += transition(prefix + std::to_string((i + 1) % count));
      if (depth == 0 && chance(0.3)) {
        if (chance(0.5)) text += "    history = true,\n";
        text += states(prefix + std::to_string(i) + "_", depth + 1);
      }
      text += "  },\n";
    }
    return text;
  }

  void write_machine() {
    text_ += "behavior \"" + generated_name(number_) + "\" {\n  priority = " + std::to_string(below(100)) + ",\n";
    if (chance(0.4)) text_ += "  common = {\n" + transition("s1") + "  },\n";
    text_ += states("s", 0) + "}\n";
  }

  std::uint64_t number_;
  Random random_;
  std::string text_;
  int names_ = 0;
  std::vector<std::string> numbers_, strings_, booleans_, times_, calls_;
};

}  // namespace

std::string generated_script(std::uint64_t number) { return Generator(number).run(); }

std::string generated_name(std::uint64_t number) { return "generated_" + std::to_string(number); }

}  // namespace reorient
