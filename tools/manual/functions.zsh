
# Candidates that only snell knows, for the scene on the line. _arguments puts options for compadd before the kind.
_snell_ask() {
  local -a unquoted=("${(@Q)words}") texts shown
  local -a scenes=("${(@M)unquoted:#*.glib}")
  local scene=${scenes[1]-} line
  for line in "${(@f)$(command ${_snell_program:-snell} complete ${@[-1]} "${scene/#\~/$HOME}" "${(Q)PREFIX}" 2>/dev/null)}"; do
    [[ -n $line ]] || continue
    texts+=("${line%%$'\t'*}")
    shown+=("${line/$'\t'/  -- }")
  done
  if [[ ${texts[1]-} == *= ]]; then compadd "${(@)@[1,-2]}" -S '' -l -d shown -a texts; else compadd "${(@)@[1,-2]}" -l -d shown -a texts; fi
}
