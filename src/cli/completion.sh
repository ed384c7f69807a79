#compdef rotconv
# Completion of rotconv for bash and zsh, and the part of it that fish has run by sh. Written at build time: the words stand in the program's own tables.

@words@

# _rotconv_candidates WORD BEFORE...: what WORD may become after the words BEFORE, in `candidates`, a line each of a word and
# what is said of it. `files` is set where it may be a file too, `open` where more may follow the word at once.
_rotconv_candidates() {
    if [ -n "${ZSH_VERSION-}" ]; then
        emulate -L sh
    fi
    local word=$1 command= argument= operand= before prefix= newline='
'
    local commands names presets projects operands options modifiers sequences
    shift
    _rotconv_words
    for before; do
        if [ -n "$argument" ]; then
            argument=
            continue
        fi
        case $before in
        --*=*) ;;
        -?*) _rotconv_argument "$before" ;;
        *)
            case "$newline$commands" in
            *"$newline$before "*) [ -n "$operand" ] || command=$before ;;
            esac
            operand=yes
            _rotconv_words "$command"
            ;;
        esac
    done
    case $argument$word in
    --*=*)
        _rotconv_argument "${word%%=*}"
        prefix=${word%%=*}=
        word=${word#*=}
        ;;
    esac

    case $argument in
    ,*)
        argument=${argument#,}
        prefix=$prefix${word%"${word##*,}"}
        word=${word##*,}
        ;;
    esac

    candidates= files= open=
    case $argument in
    '')
        case $word in
        -*) candidates=$options ;;
        *)
            if [ -n "$operands" ]; then
                _rotconv_add "$operands"
            else
                [ -n "$operand" ] || candidates=$commands
                files=yes
            fi
            ;;
        esac
        ;;
    SPEC | KNOWN) _rotconv_spec ;;
    NAME | SET) _rotconv_add "$names" ;;
    =*)
        local IFS=,
        _rotconv_add "${argument#=}"
        ;;
    FILE) files=yes ;;
    esac
}

# The argument that the option $1 awaits.
_rotconv_argument() {
    local lines=$newline$options
    argument=${lines#*"$newline$1 "}
    [ "$argument" != "$lines" ] || argument=-
    argument=${argument%% *}
    argument=${argument#-}
}

# Adds the words of a list, each behind the prefix.
_rotconv_add() {
    local added
    for added in $1; do
        candidates="$candidates$prefix$added -$newline"
    done
}

# Names, or what may follow the last colon of the word.
_rotconv_spec() {
    open=yes
    case $word in
    *:*)
        _rotconv_words "$command" "${word%%:*}"
        prefix=$prefix${word%:*}:
        case ${word#*:} in
        *:*) _rotconv_add "$modifiers $presets" ;;
        *) _rotconv_add "${sequences:-$modifiers $presets}" ;;
        esac
        ;;
    *) _rotconv_add "$names" ;;
    esac
}

# The rest is for bash and zsh alone.

if [ -n "${ZSH_VERSION-}" ]; then
    _rotconv() {
        local candidates files open
        local -a lines found shown
        _rotconv_candidates "${words[CURRENT]}" "${(@)words[2,CURRENT-1]}"
        lines=("${(@f)candidates}")
        found=("${(@)lines%% *}")
        shown=("${(@)lines/ [^ ]## #/  }")
        compadd ${open:+-S} ${open:+''} -l -d shown -a found
        if [[ -n $files ]]; then
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
        local candidates files open word candidate
        local line=${COMP_LINE:0:COMP_POINT}
        local -a before
        word=${line##*[[:blank:]]}
        read -ra before <<< "${line%"$word"}"
        _rotconv_candidates "$word" "${before[@]:1}"
        # Readline takes what stands behind the last of its breaks for the word.
        local cut=$word
        cut=${cut%"${cut##*[:=]}"}
        COMPREPLY=()
        while read -r candidate _; do
            if [[ -n $candidate && $candidate == "$word"* ]]; then
                COMPREPLY+=("${candidate#"$cut"}")
            fi
        done <<< "$candidates"
        if [[ -n $open ]]; then
            compopt -o nospace 2> /dev/null
        fi
        if [[ -n $files ]]; then
            compopt -o filenames 2> /dev/null
            while read -r candidate; do
                COMPREPLY+=("$candidate")
            done < <(compgen -f -- "${word#"$cut"}")
        fi
    }
    complete -F _rotconv rotconv
fi
