# cmake -D DEPFILE=… -D STAMP=… -P GliftDepfile.cmake: the last step of glift_compile's command.
#
# Rewrites gliftc's depfile: its target must be the stamp, which is the output of the build's rule, not gliftc's
# outputs. Then makes or touches the stamp.

file(READ "${DEPFILE}" text)
string(REPLACE " " "\\ " target "${STAMP}")
string(REGEX REPLACE "^([^:]|:[^ \n\\])*:" "${target}:" text "${text}")
file(WRITE "${DEPFILE}" "${text}")
file(TOUCH "${STAMP}")
