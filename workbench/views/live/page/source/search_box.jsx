// SPDX-License-Identifier: MIT
// A box for a search. The key "/" goes to that of the shown panel.

/// placeholder: what to type; label: for screen readers; value, onSearch: the text.
export function SearchBox({ placeholder, label = placeholder, value, onSearch }) {
  return (
    <input
      class="grow"
      type="search"
      placeholder={placeholder}
      aria-label={label}
      value={value}
      onInput={(event) => onSearch(event.currentTarget.value)}
    />
  );
}
