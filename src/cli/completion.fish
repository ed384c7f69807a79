# Completion of rotconv for fish, as completion.sh has it for the other shells.

function __rotconv_complete
    set -l before (commandline -opc)
    set -l word (commandline -ct)
    set -l lines ($before[1] --complete "$word" $before[2..-1] 2> /dev/null)
    for line in $lines[2..-1]
        string replace ' ' \t -- $line
    end
    test "$lines[1]" != files; or __fish_complete_path "$word"
end

complete -c rotconv -f -a '(__rotconv_complete)'
