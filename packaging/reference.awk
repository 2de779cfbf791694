# SPDX-License-Identifier: MIT
# reference.awk: the table of docs/REFERENCE.md from the public headers that are named: each class with
# the first sentence of its comment, under its layer and header.

function begin_layer() {
    print (layer == "" ? "" : "\n") "## Layer " folder[2] "\n\n| Class | `<l3d/...>` | |\n|---|---|---|"
    layer = folder[2]
}

# In a table's cell, a bar ends it.
function cell(text) {
    gsub(/\|/, "\\|", text)
    return text
}

FNR == 1 {
    count = split(FILENAME, folder, "/")
    doc = ""
}
# An empty line ends what may be the first sentence; a dot between blanks is a product.
/^\/\/\// {
    sub(/^\/\/\/ ?/, "")
    is_over = is_over || $0 == "" && doc != ""
    if (!is_over)
        doc = doc (doc == "" ? "" : " ") $0
    next
}
{ sub(/^template *<.*> */, "") }
$0 == "" && doc != "" { next }
/^(enum )?(class|struct) (L3D_PUBLIC )?l3d_[a-z0-9_]+[^a-z0-9_<]/ && !/^[^{]*;$/ {
    name = $0
    sub(/^(enum )?(class|struct) (L3D_PUBLIC )?/, "", name)
    sub(/[^a-z0-9_].*/, "", name)
    if (match(doc, /[^ ]\. /))
        doc = substr(doc, 1, RSTART)
    sub(/\.$/, "", doc)
    if (layer != folder[2])
        begin_layer()
    print "| `" name "` | " folder[count] " | " cell(doc) ". |"
}
{
    doc = ""
    is_over = 0
}
