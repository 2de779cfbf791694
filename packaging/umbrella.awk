# SPDX-License-Identifier: MIT
# umbrella.awk: from the list of public headers to the one that includes them all.

BEGIN {
    print "// SPDX-License-Identifier: MIT"
    print "// All of l3d. A program that includes only the headers that it needs compiles sooner."
    print "#ifndef L3D_L3D_H\n#define L3D_L3D_H\n"
}

/^#/ { next }

{
    sub(/.*\//, "")
    print "#include <l3d/" $0 ">"
}

END { print "\n#endif" }
