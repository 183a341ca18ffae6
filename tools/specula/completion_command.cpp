#include <cstdio>

#include "tools/specula/commands.hpp"

namespace specula {

void completion_command(const std::string& shell, const std::vector<std::string>& commands) {
    std::string words;
    for (const std::string& command : commands) words += (words.empty() ? "" : " ") + command;
    if (shell == "zsh") std::printf("autoload -U +X bashcompinit && bashcompinit\n");
    std::printf(
        "_specula() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} words= kind kinds=\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        words='%s'\n"
        "    elif [ \"${word#-}\" != \"$word\" ]; then\n"
        "        words=$(\"${COMP_WORDS[0]}\" \"${COMP_WORDS[1]}\" --help 2>/dev/null |\n"
        "                grep -oE -- '--[a-z-]+' | sort -u)\n"
        "    elif [ \"$COMP_CWORD\" -eq 2 ]; then\n"
        "        case ${COMP_WORDS[1]} in\n"
        "        list) words='materials radars experiments datasets sweeps' ;;\n"
        "        completion) words='bash zsh' ;;\n"
        "        export) words='model adc dca1000 rdif injection uart infineon npy csv datasheet "
        "croissant' ;;\n"
        "        bench) words='generate stages trace channel receiver frames storage learning growth threads'"
        " ;;\n"
        "        study) kinds=experiments ;;\n"
        "        generate) kinds='datasets experiments' ;;\n"
        "        sweep) kinds=sweeps ;;\n"
        "        show) words='material radar experiment sweep'\n"
        "              kinds='materials radars experiments sweeps' ;;\n"
        "        esac\n"
        "    elif [ \"$COMP_CWORD\" -eq 3 ] && [ \"${COMP_WORDS[1]}\" = show ]; then\n"
        "        kinds=${COMP_WORDS[2]}s\n"
        "    fi\n"
        "    for kind in $(echo $kinds); do\n"
        "        words=\"$words $(\"${COMP_WORDS[0]}\" list \"$kind\" 2>/dev/null |\n"
        "                       sed '1d;s/ .*//')\"\n"
        "    done\n"
        "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
        "}\n"
        "complete -o default -F _specula specula ./specula  # default: files\n",
        words.c_str());
}

}  // namespace specula
