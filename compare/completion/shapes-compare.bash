# SPDX-License-Identifier: MIT
# Completion for bash: source this file, or put it where bash-completion looks for it.

_shapes_compare() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]} words
  if ((COMP_CWORD == 1)); then
    words="run scene list --help --help-all --version"
  elif [[ "$previous" == --scenes ]]; then
    words=$("$program" list 2>/dev/null | cut -d ' ' -f 1)
  elif [[ "$previous" == --engines ]]; then
    words=$("$program" list --engines 2>/dev/null | cut -d ' ' -f 1)
  elif [[ "$current" == -* ]]; then
    # The options of the command as it explains them itself: nothing to forget here.
    words=$("$program" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -oE -- '^ +(-h,)?--[a-z-]+' | grep -oE -- '--.*')
  else
    # Files and folders.
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    return
  fi
  # Of a list with commas, the last word.
  local before=""
  if [[ "$current" == *,* ]]; then before=${current%,*},; fi
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$words" -- "${current##*,}")
}
complete -o filenames -F _shapes_compare shapes-compare
