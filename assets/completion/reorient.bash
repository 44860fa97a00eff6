# SPDX-License-Identifier: MIT
# Completion of reorient for bash, installed as share/bash-completion/completions/reorient. For one shell:
#   source assets/completion/reorient.bash
# The program itself prints the candidates: a line each, with a tab before their descriptions.

_reorient() {
  local typed=${COMP_LINE:0:COMP_POINT} words line word kept=''
  read -ra words <<<"$typed"
  [[ $typed == *[[:space:]] ]] && words+=('')
  word=${words[-1]}
  # Bash completes only what follows the last '=' of a word.
  [[ $COMP_WORDBREAKS == *=* && $word == *=* ]] && kept=${word%=*}=
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      $'\tfiles') compopt -o default ;;
      $'\tfolders') [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o dirnames ;;
      *) line=${line%%$'\t'*}; COMPREPLY+=("${line#"$kept"}") ;;
    esac
  done < <("${words[0]}" complete "${words[@]:1}" 2>/dev/null)
  [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
  return 0
}
complete -F _reorient reorient
