# SPDX-License-Identifier: MIT
# completion.awk: completion for a shell from what a program says with --help, so that options have
# their texts in one place. Given: program, shell (bash or zsh).

# Words of a kind such as "lambert|gouraud=lambert".
function words(kind) {
    sub(/=.*/, "", kind)
    gsub(/\|/, " ", kind)
    return kind
}

# Remembers how the values of an option complete: words to choose from, or a file's name.
function value(flag, kind) {
    if (kind ~ /^[a-z0-9]+\|/)
        choice[flag] = words(kind)
    else if (kind ~ /^FILE/)
        choice[flag] = "FILE"
    else if (kind ~ /^FOLDER/)
        choice[flag] = "FOLDER"
    else if (kind != "")
        choice[flag] = "OTHER"
}

/^  -/ {
    count = split($1, names, ",")
    name = names[count]
    kind = $0 ~ /^  [^ ]+ [^ ]/ ? $2 : ""
    flags[++total] = name
    help = $0
    sub(/^  [^ ]+( [^ ]+)? */, "", help)
    texts[name] = help
    value(name, kind)
    last = name
    next
}
/^                / {
    sub(/^ +/, "")
    texts[last] = texts[last] (texts[last] == "" ? "" : " ") $0
}

function action(flag) {
    if (choice[flag] == "FILE")
        return shell == "zsh" ? "_files" : "compgen -f -- \"$word\""
    if (choice[flag] == "FOLDER")
        return shell == "zsh" ? "_files -/" : "compgen -d -- \"$word\""
    if (flag == "--backend")
        return shell == "zsh" ? "(auto xshm ximage mesa mesa\\:egl mesa\\:osmesa memory)" : "compgen -W 'auto xshm ximage mesa mesa:egl mesa:osmesa memory' -- \"$word\""
    if (choice[flag] == "OTHER")
        return shell == "zsh" ? " " : ":"
    return shell == "zsh" ? "(" choice[flag] ")" : "compgen -W '" choice[flag] "' -- \"$word\""
}

function bash(    i, all, name) {
    name = program
    gsub(/-/, "_", name)
    print "_" name "() {"
    print "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}"
    print "    case $before in"
    for (i = 1; i <= total; ++i) {
        all = all " " flags[i]
        if (flags[i] in choice)
            printf "    %s) mapfile -t COMPREPLY < <(%s) ; return ;;\n", flags[i], action(flags[i])
    }
    print "    esac"
    print "    if [[ $word == -* ]]; then"
    printf "        mapfile -t COMPREPLY < <(compgen -W '%s' -- \"$word\")\n", substr(all, 2)
    print "    else"
    print "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")"
    print "    fi"
    print "}"
    print "complete -o filenames -F _" name " " program
}

# In an _arguments specification a colon ends a part, a bracket the text, and a quote the word.
function escaped(text) {
    gsub(/'/, "", text)
    gsub(/\\/, "\\\\", text)
    gsub(/\[/, "(", text)
    gsub(/\]/, ")", text)
    gsub(/:/, "\\:", text)
    return text
}

function zsh(    i, spec) {
    print "#compdef " program
    print "_arguments \\"
    for (i = 1; i <= total; ++i) {
        spec = flags[i] "[" escaped(texts[flags[i]]) "]"
        if (flags[i] in choice)
            spec = spec ":value:" action(flags[i])
        printf "    '%s' \\\n", spec
    }
    print "    '*:file:_files'"
}

END {
    if (shell == "zsh")
        zsh()
    else
        bash()
}
