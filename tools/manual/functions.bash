
# _snell_unquoted WORD: REPLY is what the shell would make of it, without expanding anything.
_snell_unquoted() {
  local quote= c i
  REPLY=
  for ((i = 0; i < ${#1}; ++i)); do
    c=${1:i:1}
    if [[ -n $quote && $c == "$quote" ]]; then
      quote=
    elif [[ -z $quote && $c == [\'\"] ]]; then
      quote=$c
    elif [[ $c == \\ && $quote != \' ]]; then
      ((++i))
      REPLY+=${1:i:1}
    else
      REPLY+=$c
    fi
  done
}

# _snell_ask KIND WORD: candidates that only snell knows, for the scene on the line. They are quoted, because their
# names are those of the scene.
_snell_ask() {
  local kind=$1 word=$2 scene= program=${words[0]/#\~/$HOME} w REPLY
  for w in "${words[@]:1:${#words[@]}-2}"; do
    _snell_unquoted "$w"
    [[ $REPLY == *.glib ]] && scene=$REPLY && break
  done
  type -t -- "$program" >/dev/null || program=snell
  local candidates=()
  mapfile -t candidates < <("$program" complete "$kind" "${scene/#\~/$HOME}" "$word" 2>/dev/null)
  COMPREPLY=()
  for w in "${candidates[@]%%$'\t'*}"; do
    printf -v w %q "$w"
    COMPREPLY+=("${w//\\,/,}")  # a comma means nothing outside of braces, which are quoted
  done
  [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2>/dev/null
}

# _snell_value KIND WORD: the value of an option, or an argument.
_snell_value() {
  case $1 in
    none) ;;
    file) mapfile -t COMPREPLY < <(compgen -f -- "$2"); compopt -o filenames 2>/dev/null ;;
    folder) mapfile -t COMPREPLY < <(compgen -d -- "$2"); compopt -o filenames 2>/dev/null ;;
    scene) mapfile -t COMPREPLY < <(compgen -f -X '!*.glib' -- "$2"; compgen -d -- "$2"); compopt -o filenames 2>/dev/null ;;
    ask:*) _snell_ask "${1#ask:}" "$2" ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
       [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2>/dev/null ;;
  esac
}

_snell() {
  local words=() w command= cur prev kind
  # Bash splits words at = and :, which belong to the words of snell.
  for w in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
    if ((${#words[@]} > 1)) && [[ $w == [=:]* || ${words[-1]} == *[=:] ]]; then words[-1]+=$w; else words+=("$w"); fi
  done
  # --color may stand ahead of the subcommand.
  while ((${#words[@]} > 2)) && [[ ${words[1]} == --color=* ]]; do words=("${words[0]}" "${words[@]:2}"); done
  while ((${#words[@]} > 3)) && [[ ${words[1]} == --color ]]; do words=("${words[0]}" "${words[@]:3}"); done
  cur=${words[-1]} prev=${words[-2]}
  if ((${#words[@]} > 2)) && [[ " $_snell_commands " == *" ${words[1]} "* ]]; then command=${words[1]}; fi
  COMPREPLY=()
  if [[ $cur == --*=* ]]; then
    kind=$(_snell_takes "$command" "${cur%%=*}")
    [[ -z $kind ]] || _snell_value "$kind" "${cur#*=}"
  elif kind=$(_snell_takes "$command" "$prev") && [[ -n $kind ]]; then
    _snell_value "$kind" "$cur"
  elif [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_snell_options "$command")" -- "$cur")
  else
    _snell_value "$(_snell_argument "$command")" "$cur"
    ((${#words[@]} > 2)) || mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$_snell_commands" -- "$cur")
  fi
  # Bash replaces only what follows its last break.
  local kept=${cur%"${cur##*[=:]}"}
  [[ $cur != --*=* ]] || kept=${kept#*=}
  [[ -z $kept || $COMP_WORDBREAKS != *=* ]] || COMPREPLY=("${COMPREPLY[@]#"$kept"}")
}

complete -F _snell snell
