#include <cstdio>

#include "tools/specula/commands.hpp"

namespace specula {

void completion_command(const std::string& shell, const std::vector<std::string>& commands) {
    std::string words;
    for (const std::string& command : commands) words += (words.empty() ? "" : " ") + command;
    if (shell == "zsh") std::printf("autoload -U +X bashcompinit && bashcompinit\n");
    std::printf(
        "_specula() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]}\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        COMPREPLY=($(compgen -W '%s' -- \"$word\"))\n"
        "    elif [ \"${word#-}\" != \"$word\" ]; then\n"
        "        local options\n"
        "        options=$(\"${COMP_WORDS[0]}\" \"${COMP_WORDS[1]}\" --help 2>/dev/null |\n"
        "                  grep -oE -- '--[a-z-]+' | sort -u)\n"
        "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
        "    elif [ \"${COMP_WORDS[1]}\" = list ]; then\n"
        "        COMPREPLY=($(compgen -W 'materials radars experiments' -- \"$word\"))\n"
        "    else\n"
        "        COMPREPLY=($(compgen -f -- \"$word\"))\n"
        "    fi\n"
        "}\n"
        "complete -F _specula specula ./specula\n",
        words.c_str());
}

}  // namespace specula
