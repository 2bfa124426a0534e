if exists("b:did_ftplugin")
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=#\ %s comments=:#,:// formatprg=snell\ format\ - expandtab shiftwidth=4
let b:undo_ftplugin = "setlocal commentstring< comments< formatprg< expandtab< shiftwidth<"
