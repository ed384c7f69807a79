#!/bin/sh
# layers_test.sh SOURCE: a file includes only files of its own layer and of those below; src/README.md has the table. What
# stands against it would be listed here, each with its reason; a line that is not needed fails too, so that the list stays empty.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat > "$work/exceptions" <<'END'
END

# Prints what is wrong in the folder $1, but for the exceptions in the file $2.
violations() {
    (cd "$1" && find include src -name '*.[hc]pp' | sort | xargs awk '
        function layer_of(path) {
            if (path ~ /^src\/cli\//) return 6
            if (path ~ /^src\/operations\//) return 5
            if (path ~ /^src\/stream\//) return 4
            if (path ~ /^src\/methods\//) return 3
            if (path ~ /^src\/core\/kinematics\//) return 2
            if (path ~ /^include\/rotconv\/(rotconv|rates|integration|propagation)\.hpp$/) return 2
            if (path ~ /^src\/core\/numerics\/|^include\/rotconv\/(angle|version)\.hpp$/) return 0
            if (path ~ /^(src\/core(\/(representations|conversion|identification))?|include\/rotconv)\/[^\/]*$/) return 1
            return -1
        }
        # The libraries that not every layer may know.
        function lowest_user_of(library) {
            if (library ~ /^CLI\//) return 6
            if (library ~ /^(fmt|dragonbox|fast_float)\//) return 4
            return -1
        }
        function exists(path,   line, found) {
            found = (getline line < path) >= 0
            close(path)
            return found
        }
        FILENAME == exceptions { excepted[$1 " " $2] = 1; next }
        FNR == 1 && layer_of(FILENAME) < 0 { print FILENAME ": in no layer" }
        /^[ \t]*#[ \t]*include/ {
            name = $0
            sub(/^[^<"]*/, "", name)
            beside = name ~ /^"/
            name = substr(name, 2)
            sub(/[>"].*/, "", name)
            if (beside) {
                path = FILENAME
                sub(/[^\/]*$/, name, path)
                while (sub(/[^\/]+\/\.\.\//, "", path)) {}
            } else if (name ~ /^rotconv\//) {
                path = "include/" name
            } else {
                if (lowest_user_of(name) > layer_of(FILENAME)) print FILENAME ": includes " name ", which its layer does not use"
                next
            }
            edge = FILENAME " " path
            if (!exists(path)) print FILENAME ": includes " path ", which is not there"
            else if (layer_of(path) > layer_of(FILENAME)) {
                if (edge in excepted) used[edge] = 1
                else print FILENAME ": includes " path ", which is in a layer above"
            }
        }
        END { for (edge in excepted) if (!(edge in used)) print edge ": the exception is no longer needed" }
    ' exceptions="$2" "$2")
}

fail() {
    echo "FAILED: $*"
    exit 1
}

# In a made-up house each kind of violation is seen, and what is allowed is not.
mkdir -p "$work/house/include/rotconv" "$work/house/src/core/numerics" "$work/house/src/stream"
cd "$work/house"
echo '#include "../../stream/file.hpp"' > src/core/numerics/above.hpp
echo '#include <fmt/format.h>' > src/core/library.cpp
echo '#include "nowhere.hpp"' > src/core/numerics/missing.cpp
echo '#include <vector>' > src/elsewhere.cpp
printf '#include "../core/numerics/above.hpp"\n  #  include <rotconv/dcm.hpp> // "below"\n#include <fmt/format.h>\n' > src/stream/file.hpp
echo '#include <rotconv/rates.hpp>' > include/rotconv/dcm.hpp
echo '#include <rotconv/dcm.hpp>' > include/rotconv/rates.hpp
printf '%s\n' 'include/rotconv/dcm.hpp include/rotconv/rates.hpp excepted' 'src/a.cpp src/b.hpp stale' > "$work/of_house"
violations "$work/house" "$work/of_house" > "$work/seen"
cat > "$work/expected" <<'END'
src/a.cpp src/b.hpp: the exception is no longer needed
src/core/library.cpp: includes fmt/format.h, which its layer does not use
src/core/numerics/above.hpp: includes src/stream/file.hpp, which is in a layer above
src/core/numerics/missing.cpp: includes src/core/numerics/nowhere.hpp, which is not there
src/elsewhere.cpp: in no layer
END
LC_ALL=C sort "$work/seen" | diff "$work/expected" - || fail "the made-up violations are not seen as they should be"

violations "$1" "$work/exceptions" > "$work/seen"
[ ! -s "$work/seen" ] || fail "$(cat "$work/seen")"
