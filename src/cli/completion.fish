# Completion of rotconv for fish. What a word may become is found by sh, as for the other shells.

set -g __rotconv_candidates '
@candidates@
_rotconv_candidates "$@"
printf "%s" "$candidates" | while read -r word argument text; do printf "%s\\\\t%s\\\\n" "$word" "$text"; done
[ -z "$files" ]'

function __rotconv_complete
    set -l before (commandline -opc)
    set -l word (commandline -ct)
    sh -c $__rotconv_candidates sh "$word" $before[2..-1]
    or __fish_complete_path "$word"
end

complete -c rotconv -f -a '(__rotconv_complete)'
