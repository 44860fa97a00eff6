local memory = keep { n = 0, list = { 1, "two", true } }
local other = keep {}
behavior "b" {
  update = function()
    memory.n = memory.n + 1
    memory.list[#memory.list + 1] = { memory.n }
    other.self = other
    other[memory.n] = ("x"):rep(memory.n)
  end,
}
ÿlocal memory = keep { n = "text", list = {} }
behavior "b" {
  update = function() print(memory.n, #memory.list) end,
}
behavior "c" { enter = function() error("c") end }
