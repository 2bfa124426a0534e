" Vim syntax file for GLIB scenes. Written by snell_docs from the table of commands.
if exists("b:current_syntax")
  finish
endif

syntax case ignore
syntax keyword glibCommand Background
syntax keyword glibCommand Blend
syntax keyword glibCommand Box
syntax keyword glibCommand Clamp
syntax keyword glibCommand Clear
syntax keyword glibCommand Color
syntax keyword glibCommand Cone
syntax keyword glibCommand Cube
syntax keyword glibCommand CubeMap
syntax keyword glibCommand CullFace
syntax keyword glibCommand Cylinder
syntax keyword glibCommand DepthTest
syntax keyword glibCommand DepthWrite
syntax keyword glibCommand DiskXY
syntax keyword glibCommand Filter
syntax keyword glibCommand Flat
syntax keyword glibCommand Fragment
syntax keyword glibCommand Geometry
syntax keyword glibCommand GeometryInput
syntax keyword glibCommand GeometryOutput
syntax keyword glibCommand glBegin
syntax keyword glibCommand glColor
syntax keyword glibCommand glEnd
syntax keyword glibCommand glNormal
syntax keyword glibCommand glTexCoord
syntax keyword glibCommand glVertex
syntax keyword glibCommand GSTAP
syntax keyword glibCommand Include
syntax keyword glibCommand Irradiance
syntax keyword glibCommand JitterCloud
syntax keyword glibCommand Ladder
syntax keyword glibCommand LinesAdjacency
syntax keyword glibCommand LineWidth
syntax keyword glibCommand LookAt
syntax keyword glibCommand MessageBox
syntax keyword glibCommand Noise2D
syntax keyword glibCommand Noise3D
syntax keyword glibCommand NumPatchVertices
syntax keyword glibCommand Obj
syntax keyword glibCommand ObjAdj
syntax keyword glibCommand ObjPatch
syntax keyword glibCommand Ortho
syntax keyword glibCommand Output
syntax keyword glibCommand Persp
syntax keyword glibCommand Perspective
syntax keyword glibCommand PointCloud
syntax keyword glibCommand PointSize
syntax keyword glibCommand PointSizeMode
syntax keyword glibCommand PopMatrix
syntax keyword glibCommand Prefilter
syntax keyword glibCommand Program
syntax keyword glibCommand PushMatrix
syntax keyword glibCommand QuadBox
syntax keyword glibCommand QuadXY
syntax keyword glibCommand QuadXZ
syntax keyword glibCommand QuadYZ
syntax keyword glibCommand RenderToCube
syntax keyword glibCommand RenderToTexture
syntax keyword glibCommand Rotate
syntax keyword glibCommand Scale
syntax keyword glibCommand Shp
syntax keyword glibCommand Smooth
syntax keyword glibCommand Soccerball
syntax keyword glibCommand Sphere
syntax keyword glibCommand Teapot
syntax keyword glibCommand TessControl
syntax keyword glibCommand TessEvaluation
syntax keyword glibCommand Texture1D
syntax keyword glibCommand Texture2D
syntax keyword glibCommand Texture3D
syntax keyword glibCommand Timer
syntax keyword glibCommand Torus
syntax keyword glibCommand TransformBegin
syntax keyword glibCommand TransformEnd
syntax keyword glibCommand Translate
syntax keyword glibCommand Triangles
syntax keyword glibCommand Verbose
syntax keyword glibCommand Vertex
syntax keyword glibCommand WindowSize
syntax keyword glibCommand WireBox
syntax keyword glibCommand WireCone
syntax keyword glibCommand WireCube
syntax keyword glibCommand WireCylinder
syntax keyword glibCommand Wireframe
syntax keyword glibCommand WireObj
syntax keyword glibCommand WireSphere
syntax keyword glibCommand WireTeapot
syntax keyword glibCommand WireTorus
syntax keyword glibCommand Xarrow
syntax case match
syntax keyword glibConstant anisotropic
syntax keyword glibConstant back
syntax keyword glibConstant dst_alpha
syntax keyword glibConstant dst_color
syntax keyword glibConstant front
syntax keyword glibConstant gl_line_loop
syntax keyword glibConstant gl_line_strip
syntax keyword glibConstant gl_line_strip_adjacency
syntax keyword glibConstant gl_lines
syntax keyword glibConstant gl_lines_adjacency
syntax keyword glibConstant gl_patches
syntax keyword glibConstant gl_points
syntax keyword glibConstant gl_triangle_fan
syntax keyword glibConstant gl_triangle_strip
syntax keyword glibConstant gl_triangle_strip_adjacency
syntax keyword glibConstant gl_triangles
syntax keyword glibConstant gl_triangles_adjacency
syntax keyword glibConstant linear
syntax keyword glibConstant mipmap
syntax keyword glibConstant nearest
syntax keyword glibConstant none
syntax keyword glibConstant off
syntax keyword glibConstant on
syntax keyword glibConstant one
syntax keyword glibConstant one_minus_dst_alpha
syntax keyword glibConstant one_minus_dst_color
syntax keyword glibConstant one_minus_src_alpha
syntax keyword glibConstant one_minus_src_color
syntax keyword glibConstant raw
syntax keyword glibConstant src_alpha
syntax keyword glibConstant src_alpha_saturate
syntax keyword glibConstant src_color
syntax keyword glibConstant srgb
syntax keyword glibConstant zero
syntax keyword glibConstant true false
syntax match glibNumber "\v[-+]?<(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?"
syntax match glibNumber "\v[-+]?\.\d+([eE][-+]?\d+)?"
syntax region glibString start=+"+ end=+"+ oneline
syntax match glibBracket "[<>\[\]{}]"
syntax match glibContinuation "\\\s*$"
syntax match glibComment "#.*$"
syntax match glibComment "//.*$"

highlight default link glibCommand Statement
highlight default link glibConstant Constant
highlight default link glibNumber Number
highlight default link glibString String
highlight default link glibBracket Delimiter
highlight default link glibContinuation Special
highlight default link glibComment Comment

let b:current_syntax = "glib"
