if exists("b:did_ftplugin")
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=//\ %s comments=:///,:// textwidth=120
setlocal expandtab shiftwidth=4 softtabstop=4 cindent cinoptions+=L0
let b:undo_ftplugin = "setlocal commentstring< comments< textwidth< expandtab< shiftwidth< softtabstop< cindent< cinoptions<"
