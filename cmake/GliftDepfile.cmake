# cmake -D DEPFILE=… -D STAMP=… -P GliftDepfile.cmake: the last step of glift_compile's command.
#
# Rewrites gliftc's depfile: its target must be the stamp, which is the output of the build's rule, not gliftc's
# outputs. Then makes or touches the stamp.

file(READ "${DEPFILE}" text)
string(REGEX MATCH "^([^:]|:[^ \n\\])*:" outputs "${text}")
string(LENGTH "${outputs}" end)
string(SUBSTRING "${text}" ${end} -1 dependencies)
string(REPLACE " " "\\ " target "${STAMP}")
string(REPLACE "#" "\\#" target "${target}")
string(REPLACE "$" "$$" target "${target}")
file(WRITE "${DEPFILE}" "${target}:${dependencies}")
file(TOUCH "${STAMP}")
