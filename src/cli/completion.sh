#compdef rotconv
# Completion of rotconv for bash and zsh. The program says what a word may become: see completions() of command.hpp.

if [ -n "${ZSH_VERSION-}" ]; then
    _rotconv() {
        local -a lines found shown open
        lines=("${(@f)$(${~words[1]} --complete "${words[CURRENT]}" "${(@)words[2,CURRENT-1]}" 2> /dev/null)}")
        local kind=${lines[1]}
        shift lines
        found=("${(@)lines%% *}")
        shown=("${(@)lines/ /  }")
        [[ $kind != open ]] || open=(-S '')
        compadd "${open[@]}" -l -d shown -a found
        if [[ $kind = files ]]; then
            _files
        fi
    }
    if [ "${funcstack[1]-}" = _rotconv ]; then
        _rotconv "$@"
    else
        compdef _rotconv rotconv
    fi
else
    _rotconv() {
        local kind word candidate
        local line=${COMP_LINE:0:COMP_POINT}
        local -a before
        word=${line##*[[:blank:]]}
        read -ra before <<< "${line%"$word"}"
        # Readline takes what stands behind the last of its breaks for the word.
        local cut=$word
        cut=${cut%"${cut##*[:=]}"}
        COMPREPLY=()
        while read -r candidate _; do
            if [[ -z ${kind-} ]]; then
                kind=$candidate
            elif [[ $candidate == "$word"* ]]; then
                COMPREPLY+=("${candidate#"$cut"}")
            fi
        done < <("${before[0]/#\~/$HOME}" --complete "$word" "${before[@]:1}" 2> /dev/null)
        if [[ $kind == open ]]; then
            compopt -o nospace 2> /dev/null
        elif [[ $kind == files ]]; then
            compopt -o filenames 2> /dev/null
            while read -r candidate; do
                COMPREPLY+=("$candidate")
            done < <(compgen -f -- "${word#"$cut"}")
        fi
    }
    complete -F _rotconv rotconv
fi
