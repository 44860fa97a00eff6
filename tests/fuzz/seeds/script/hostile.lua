local kind = {}
local one = setmetatable({}, kind)
local function open()
  local a <close> = one
  error("again")
end
kind.__close = open
kind.__index = function(t, k) return t[k + 1] end
kind.__pairs = function(t) return open, t end
behavior "b" {
  initial = "a",
  state "a" {
    update = function()
      local t = {}
      for i = 1, 20 do t[i] = i end
      table.sort(t, function(x, y) return x > y end)
      pcall(open)
      xpcall(open, print)
      local s = ("x"):rep(100)
      for w in s:gmatch("x-(x)") do t[w] = #w end
      for k, v in pairs(t) do print(k, v, string.format("%5.2f %q", 1, "x")) end
      print((s:gsub("(x)(.)", "%2%1", 3)), s:find(".-.-b"), table.concat(t, ",", 1, 3))
    end,
    { "b", when = function() return one[1] end },
  },
  state "b" {
    enter = function() while true do end end,
    exit = function() return table.unpack({}, 1, 1e8) end,
    { "a", after = 0 },
  },
}
