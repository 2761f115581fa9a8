# cmake -D DEPFILE=… -D STAMP=… -P GliftDepfile.cmake: the last step of glift_compile's command.
#
# gliftc's depfile names what gliftc wrote; the build's rule has the stamp as its output, and ninja wants to read that.

file(READ "${DEPFILE}" text)
string(REPLACE " " "\\ " target "${STAMP}")
string(REGEX REPLACE "^([^:]|:[^ \n\\])*:" "${target}:" text "${text}")
file(WRITE "${DEPFILE}" "${text}")
file(TOUCH "${STAMP}")
