// What the shells are told: to run `pxm completion words -- WORDS` when Tab is pressed, to offer
// the lines that it prints, and names of files where it asks for them.
#include <string>

#include "host/commands/completion.hpp"
#include "host/error.hpp"
#include "host/text/nearest.hpp"

namespace pxm::host {

namespace {

constexpr const char* for_bash = R"(# bash completion of pxm, printed by `pxm completion bash`
_pxm() {
    local program=${1/#\~/$HOME} current=${COMP_WORDS[COMP_CWORD]} ending= line name
    local words=("${COMP_WORDS[@]:1:COMP_CWORD}")
    [[ $current == = ]] && current=
    COMPREPLY=()
    while IFS= read -r line; do
        case $line in
            :files\ *) ending=${line#:files } ;;&
            :files*)
                compopt -o filenames 2>/dev/null
                while IFS= read -r name; do
                    [[ -d $name || $name == *"$ending" ]] && COMPREPLY+=("$name")
                done < <(compgen -f -- "$current")
                ;;
            :folders)
                compopt -o filenames 2>/dev/null
                while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -d -- "$current")
                ;;
            *)
                name=${line%%$'\t'*}
                # bash took `--option=` for words of their own.
                [[ $current != *=* && $name == *=* ]] && name=${name#*=}
                [[ $name == *[^[:alnum:]=.,:/#+_-]* ]] && printf -v name %q "$name"
                COMPREPLY+=("$name")
                ;;
        esac
    done < <("$program" completion words -- "${words[@]//\\/}" 2>/dev/null)
}
complete -F _pxm pxm
)";

constexpr const char* for_zsh = R"(#compdef pxm
# zsh completion of pxm, printed by `pxm completion zsh`
_pxm() {
    local line name
    local -a found
    for line in "${(@f)$("${(e)words[1]}" completion words -- "${(@)words[2,CURRENT]}" 2>/dev/null)}"; do
        case $line in
            :files\ *) _files -g "*${line#:files }" ;;
            :files) _files ;;
            :folders) _files -/ ;;
            ?*)
                name=${line%%$'\t'*}
                found+=("${name//:/\\:}:${line#*$'\t'}")
                ;;
        esac
    done
    (( $#found )) && _describe -t words pxm found
}
if [[ $funcstack[1] == _pxm ]]; then
    _pxm "$@"
else
    compdef _pxm pxm
fi
)";

constexpr const char* for_fish = R"(# fish completion of pxm, printed by `pxm completion fish`
function __pxm_complete
    set -l words (commandline -opc) (commandline -ct)
    set -l current (commandline -ct | string replace -r '^--[^=]*=' '')
    set -l front (commandline -ct | string match -r '^--[^=]*=')
    for line in ($words[1] completion words -- $words[2..-1] 2>/dev/null)
        switch $line
            case ':files *'
                set -l ending (string replace ':files ' '' -- $line)
                for name in (__fish_complete_path $current)
                    string match -q -r '/(\t|$)' -- $name; and echo "$front$name"
                    string match -q -r (string escape --style=regex -- $ending)'(\t|$)' -- $name; and echo "$front$name"
                end
            case ':files'
                for name in (__fish_complete_path $current)
                    echo "$front$name"
                end
            case ':folders'
                for name in (__fish_complete_directories $current)
                    echo "$front$name"
                end
            case '*'
                echo $line
        end
    end
end
complete -c pxm -f -a '(__pxm_complete)'
)";

}  // namespace

std::string completion_script(std::string_view shell) {
    if (shell == "bash") return for_bash;
    if (shell == "zsh") return for_zsh;
    if (shell == "fish") return for_fish;
    throw Error(ErrorKind::setting, "completion: found \"" + std::string(shell) +
                                        "\", expected one of bash, zsh, fish" +
                                        suggestion(shell, {"bash", "zsh", "fish"}));
}

}  // namespace pxm::host
