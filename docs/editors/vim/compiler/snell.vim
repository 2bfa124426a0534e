" :make lists what `snell check` finds in the scene.
if exists("current_compiler")
  finish
endif
let current_compiler = "snell"

CompilerSet makeprg=snell\ check\ %:S
CompilerSet errorformat=%f:%l:%c:\ %trror:\ %m,%f:%l:%c:\ %tarning:\ %m,%f:%l:%c:\ %tote:\ %m,%-G%.%#
