; Colours of Glift.

(comment) @comment
(block_comment) @comment
(string) @string
[(integer) (float)] @number
(boolean) @constant.builtin
(none) @constant.builtin

["module" "use" "pub" "extern" "let" "var" "const" "shared" "temp" "uninitialized" "from" "group" "with" "via" "host"
 "memory" "otherwise" "mips" "apart" "filter" "compare" "vertex" "fragment" "cull" "draw" "smooth" "linear" "flat"] @keyword
["fn" "kernel" "raster" "pipeline" "test"] @keyword.function
["struct" "enum" "interface" "type" "structure" "translator"] @keyword.type
["if" "else" "switch"] @keyword.conditional
["for" "in" "while" "break" "continue"] @keyword.repeat
["return" "await" "then" "discard"] @keyword.control
(direction) @keyword.modifier
(pattern ["each" "near" "any" "at" "scatter" "coherent" "calls" "target" "instance" "range"] @keyword.modifier)

(attribute) @attribute
(path) @module
(function name: (identifier) @function)
(method name: (identifier) @function.method)
(kernel name: (identifier) @function)
(kernel_instances name: (identifier) @function)
(raster name: (identifier) @function)
(pipeline name: (identifier) @function)
(call function: (identifier) @function.call)
(call function: (member member: (identifier) @function.method.call))

(struct name: (identifier) @type.definition)
(enum name: (identifier) @type.definition)
(interface name: (identifier) @type.definition)
(alias name: (identifier) @type.definition)
(translator name: (identifier) @type.definition)
(structure name: (identifier) @type.definition)
(generic_parameter name: (identifier) @type.parameter)
(generic (identifier) @type)
(field name: (identifier) @property)
(enumerator name: (identifier) @constant)
(member member: (identifier) @property)
(parameter name: (identifier) @variable.parameter)
(closure_parameter name: (identifier) @variable.parameter)
(named_argument name: (identifier) @property)
((identifier) @type
 (#match? @type "^[A-Z]"))
((identifier) @type.builtin
 (#match? @type.builtin "^(bool|u?int(64)?|float|half|double)([2-4](x[2-4])?)?$|^(vec|mat)$"))
