local long = ("x"):rep(10000)
pcall(test, long, function() end)
test("edits", function()
  load_behavior "head_scan"
  reload { from = "e", to = long }
end)
test("simulations", function()
  local with = {}
  for i = 1, 5000 do with[i] = long end
  simulate { scenario = "mirrored_placement", with = with, params = { [long] = long } }
end)
test("failures", function() for _ = 1, 200 do expect.equal(long, long .. "y") expect.log(long) end end)
test("parameters", function() for i = 1, 1e6 do set_param("x" .. i, long) end end)
for i = 1, 1000 do test("t" .. i, function() error(long) end) end
