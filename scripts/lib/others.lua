--- Asking for other behaviours that may not be loaded.

local others = {}

--- Whether a behaviour of this name runs and is in this state, or in one within it. Where it is not loaded: false.
function others.is_in(name, state)
  local is_loaded, path = pcall(function() return behaviors[name].state end)
  return is_loaded and (path == state or path:sub(1, #state + 1) == state .. "/")
end

return others
