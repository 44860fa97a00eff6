// SPDX-License-Identifier: MIT
// Which parameters the panel lists: a filter and the words of a search; and why the list is empty.

/// id: name on the button.
const FILTERS = { all: "all", default: "changed", start: "since the start" };

/// The filters, [{id, name, count}]; that of a file only if one is compared.
export function filtersOf(parameters) {
  const filters = parameters.file ? { ...FILTERS, file: `differs from ${parameters.file.name}` } : FILTERS;
  return Object.entries(filters).map(([id, name]) => ({ id, name, count: filtered(parameters, id).length }));
}

const filtered = (parameters, id) => (id === "all" ? [...parameters.all.values()] : parameters.differing(id));
const wordsOf = (search) => search.toLowerCase().split(/\s+/).filter(Boolean);

/// The parameters of a filter that contain all words of the search. Those with the words in the name are first.
export function listed(parameters, filter, search) {
  const words = wordsOf(search);
  const isNamed = ({ name }) => words.every((word) => name.includes(word));
  const isFound = ({ name, description = "" }) =>
    words.every((word) => `${name} ${description}`.toLowerCase().includes(word));
  return filtered(parameters, filter)
    .filter(isFound)
    .sort((a, b) => isNamed(b) - isNamed(a) || (a.name < b.name ? -1 : 1));
}

/// Why nothing is listed, as one sentence.
export function whyEmpty(parameters, filter, search) {
  if (!parameters.all.size) return "The robot has not sent its parameters yet.";
  const count = filtered(parameters, filter).length;
  if (count) {
    const which = {
      all: `None of the ${count} parameters`,
      default: `None of the changed parameters (${count})`,
      start: `None of the parameters that changed since the start of the run (${count})`,
      file: `None of the parameters with another value than in ${parameters.file?.name} (${count})`,
    };
    return `${which[filter]} contains “${search.trim()}”.`;
  }
  return {
    default: "No parameter differs from its default.",
    start: "No parameter differs from its value at the start of the run.",
    file: `No parameter differs from ${parameters.file?.name}: the run has the values of the file.`,
  }[filter];
}
