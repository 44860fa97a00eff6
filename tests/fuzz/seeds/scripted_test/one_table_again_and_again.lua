-- More pairs to be compared than anybody can wait for.
local function nested(leaf)
  local t = { leaf }
  for _ = 1, 15 do
    local level = {}
    for i = 1, 20 do level[i] = t end
    t = level
  end
  return t
end
test("t", function() expect.equal(nested(1), nested(1)) end)
