// The grammar of Glift for tree-sitter, after docs/reference/grammar.ebnf. It accepts somewhat more: which items, parameters and
// statements may stand where is for the compiler to say.
//
// Words that are names elsewhere (kernel, each, memory, …) are literals here: tree-sitter takes them as words where the
// grammar asks for them, and else as names.

const precedence = {
    then: 1, range: 2, conditional: 3, otherwise: 4, or: 5, and: 6, bit_or: 7, bit_xor: 8, bit_and: 9, equality: 10,
    comparison: 11, shift: 12, sum: 13, product: 14, unary: 15, postfix: 16,
};

const list = (rule) => seq(rule, repeat(seq(",", rule)), optional(","));
const patterns = ["each", "near", "any", "at", "scatter", "coherent", "calls", "target", "instance", "range"];

module.exports = grammar({
    name: "glift",

    extras: ($) => [/\s/, $.comment, $.block_comment],
    word: ($) => $.identifier,
    conflicts: ($) => [
        [$._type, $._expression],
        [$.generic, $._expression],
        [$.generic, $._type],
        [$.pattern, $._type],
        [$.tuple, $.block],
    ],

    rules: {
        source_file: ($) => seq(optional($.module), repeat(choice($.use, $._declaration, ";"))),

        comment: () => token(seq("//", /[^\n]*/)),
        block_comment: () => token(seq("/*", /[^*]*\*+([^/*][^*]*\*+)*/, "/")),

        module: ($) => seq("module", field("name", $.path), ";"),
        use: ($) => seq("use", field("path", choice($.path, $.relative_path)), ";"),
        path: ($) => seq($.identifier, repeat(seq(".", $.identifier))),
        relative_path: () => /\.\.?\/[A-Za-z0-9_./]*/,

        // ---------------------------------------------------------------- declarations
        _declaration: ($) => choice($.function, $.struct, $.enum, $.interface, $.constant, $.alias, $.translator,
            $.structure, $.kernel, $.kernel_instances, $.raster, $.pipeline, $.test),
        _before: ($) => choice(seq(repeat1($.attribute), optional("pub")), "pub"),
        attribute: ($) => seq("@", $.identifier, optional($.arguments)),

        generics: ($) => seq("<", optional(list($.generic_parameter)), ">"),
        generic_parameter: ($) => seq(field("name", $.identifier), ":", field("constraint", $._type),
            optional(seq("=", $._generic_argument))),

        function: ($) => seq(optional($._before), "fn", field("name", $.identifier), optional($.generics),
            $.parameters, optional($.group), optional($.with), optional($.result), choice($.block, ";")),
        result: ($) => seq("->", $._type),
        group: ($) => seq("group", $.arguments),
        with: ($) => seq("with", list($.member_pattern)),
        member_pattern: ($) => seq(choice("scatter", "coherent", "calls"), $.generic_arguments),

        struct: ($) => seq(optional($._before), optional("extern"), "struct", field("name", $.identifier),
            choice(seq(optional($.generics), "{", repeat(choice($.field, ";")), "}"), seq("from", $.string, ";"))),
        field: ($) => seq(field("name", $.identifier), ":", field("type", $._type), ";"),
        enum: ($) => seq(optional($._before), "enum", field("name", $.identifier), "{",
            optional(list($.enumerator)), "}"),
        enumerator: ($) => seq(field("name", choice($.identifier, "none")), optional(seq("=", $._expression))),
        interface: ($) => seq(optional($._before), "interface", field("name", $.identifier), optional($.generics),
            "{", repeat(choice($.method, $.function, ";")), "}"),
        constant: ($) => seq(optional($._before), "const", field("name", $.identifier),
            optional(seq(":", $._type)), "=", $._expression, ";"),
        alias: ($) => seq(optional($._before), choice("type", "structure", "translator"), field("name", $.identifier),
            optional($.generics), "=", $._expression, ";"),

        kernel: ($) => seq(optional($._before), "kernel", field("name", $.identifier), optional($.generics),
            $.parameters, optional($.group), $.block),
        kernel_instances: ($) => seq(optional($._before), "kernel", field("name", $.identifier), "=",
            list($._type), ";"),
        raster: ($) => seq(optional($._before), "raster", field("name", $.identifier), optional($.generics),
            $.parameters, "{", repeat(choice($.raster_state, $.varying, $.raster_part, ";")), "}"),
        raster_state: ($) => seq(choice("cull", "draw"), $.identifier, ";"),
        varying: ($) => seq(choice("smooth", "linear", "flat"), field("name", $.identifier), ":", $._type, ";"),
        raster_part: ($) => seq(choice("vertex", "fragment"), $.block),
        pipeline: ($) => seq(optional($._before), "pipeline", field("name", $.identifier), optional($.generics),
            $.parameters, optional($.result), $.block),
        test: ($) => seq("test", field("title", $.string), $.block),

        // ---------------------------------------------------------------- components
        translator: ($) => seq(optional($._before), "translator", field("name", $.identifier), optional($.generics),
            ":", $._type, "->", $._type, "{", repeat(choice($.field, $.method, $.function, ";")), "}"),
        structure: ($) => seq(optional($._before), "structure", field("name", $.identifier), optional($.generics),
            $.parameters, optional(seq(":", $._type, "->", $._type)), $.items),
        items: ($) => seq("{", repeat(choice($.memory, $.member_structure, $.via, $.otherwise, $.host, $.condition,
            $.method, $.function, $.pipeline, ";")), "}"),
        memory: ($) => seq("memory", field("name", $.identifier), "=", $._expression,
            repeat(choice(seq("mips", $.arguments), seq("apart", $.arguments), seq("filter", $.identifier),
                seq("compare", $.identifier))), ";"),
        member_structure: ($) => seq("structure", field("name", $.identifier), "=", $._expression, ";"),
        via: ($) => seq("via", $._expression, ";"),
        otherwise: ($) => seq("otherwise", $._expression, ";"),
        host: ($) => seq("host", field("name", $.identifier), ":", $._type, "=", $._expression, ";"),
        condition: ($) => seq("if", $._expression, $.items, optional(seq("else", choice($.condition, $.items)))),
        method: ($) => seq(optional($._before), field("name", $.identifier), optional($.generics), $.parameters,
            optional($.group), optional($.with), optional($.result), choice($.block, ";")),

        // ---------------------------------------------------------------- parameters
        parameters: ($) => seq("(", optional(list($.parameter)), ")"),
        parameter: ($) => seq(field("name", $.identifier), optional(seq(":", optional($.direction),
            choice($.pattern, $._type))), optional(seq("=", $._expression))),
        direction: () => choice("in", "out", "inout"),
        pattern: ($) => prec(1, seq(choice(...patterns), optional($.generic_arguments))),

        // ---------------------------------------------------------------- types
        _type: ($) => choice($.identifier, $.generic, $.optional, alias($.type_member, $.member),
            alias($.type_index, $.index)),
        type_member: ($) => prec.left(precedence.postfix, seq($._type, ".", field("member", $.identifier))),
        type_index: ($) => prec.left(precedence.postfix, seq($._type, "[", optional($._expression), "]")),
        optional: ($) => prec.left(precedence.postfix, seq($._type, "?")),
        generic: ($) => prec.dynamic(1, seq($._named, $.generic_arguments)),
        _named: ($) => choice($.identifier, alias($.type_member, $.member)),
        generic_arguments: ($) => seq("<", optional(list(choice($.named_generic, $._generic_argument))), ">"),
        named_generic: ($) => seq(field("name", $.identifier), ":", $._generic_argument),
        _generic_argument: ($) => choice($._type, $._expression),

        // ---------------------------------------------------------------- statements
        block: ($) => seq("{", repeat($._statement), "}"),
        _statement: ($) => choice($.let, $.shared, $.temp, $.if, $.for, $.while, $.switch, $.jump, $.return, $.block,
            $.assignment, $.expression_statement, ";"),
        let: ($) => seq(choice("let", "var", "const"), field("name", $.identifier), optional(seq(":", $._type)),
            optional(seq("=", $._expression)), ";"),
        shared: ($) => seq("shared", field("name", $.identifier), ":", $._type, ";"),
        temp: ($) => seq(optional("uninitialized"), "temp", field("name", $.identifier),
            optional(seq(":", $._type)), "=", $._expression, ";"),
        if: ($) => seq("if", choice($._expression, seq("let", field("name", $.identifier), "=", $._expression)),
            $.block, optional(seq("else", choice($.if, $.block)))),
        for: ($) => seq("for", field("name", $.identifier), "in", $._expression, optional(seq("while", $._expression)),
            $.block),
        while: ($) => seq("while", $._expression, $.block),
        switch: ($) => seq("switch", $._expression, "{", repeat($.case),
            optional(seq("else", ":", $.block)), "}"),
        case: ($) => seq(list($._expression), ":", $.block),
        jump: () => seq(choice("break", "continue", "discard"), ";"),
        return: ($) => seq("return", optional($._expression), ";"),
        assignment: ($) => seq($._expression,
            choice("=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="), $._expression, ";"),
        expression_statement: ($) => seq($._expression, ";"),

        // ---------------------------------------------------------------- expressions
        _expression: ($) => choice($.identifier, $.integer, $.float, $.string, $.boolean, $.none, $.parenthesized,
            $.tuple, $.generic, $.call, $.index, $.member, $.unary, $.binary, $.conditional, $.range),
        parenthesized: ($) => seq("(", $._expression, ")"),
        tuple: ($) => seq("{", optional(list($._argument)), "}"),
        call: ($) => prec.left(precedence.postfix, seq(field("function", $._expression), $.arguments)),
        arguments: ($) => seq("(", optional(list($._argument)), ")"),
        _argument: ($) => choice($._expression, $.named_argument, $.closure),
        named_argument: ($) => seq(field("name", $.identifier), ":", choice($._expression, $.closure)),
        closure: ($) => seq(choice("||", seq("|", optional(list($.closure_parameter)), "|")),
            choice($._expression, $.block)),
        closure_parameter: ($) => seq(field("name", $.identifier), optional(seq(":", $._type))),
        index: ($) => prec.left(precedence.postfix, seq($._expression, "[", optional(list($._expression)), "]")),
        member: ($) => prec.left(precedence.postfix, seq($._expression, ".", field("member", choice($.identifier, "none")))),
        unary: ($) => prec(precedence.unary, seq(choice("+", "-", "!", "~", "await"), $._expression)),
        conditional: ($) => prec.right(precedence.conditional, seq($._expression, "?", $._expression, ":", $._expression)),
        range: ($) => prec.left(precedence.range, seq($._expression, "..", $._expression)),
        binary: ($) => choice(...[
            [["then"], "then"], [["??"], "otherwise"], [["||"], "or"], [["&&"], "and"], [["|"], "bit_or"],
            [["^"], "bit_xor"], [["&"], "bit_and"], [["==", "!="], "equality"], [["<", "<=", ">", ">="], "comparison"],
            [["<<", ">>"], "shift"], [["+", "-"], "sum"], [["*", "/", "%"], "product"],
        ].map(([operators, level]) => prec.left(precedence[level], seq($._expression,
            field("operator", choice(...operators)), $._expression)))),

        boolean: () => choice("true", "false"),
        none: () => "none",
        integer: () => token(/(0[xX][0-9a-fA-F]+|[0-9]+)(ul|u|l)?/),
        float: () => token(/[0-9]+(\.[0-9]+([eE][+-]?[0-9]+)?|[eE][+-]?[0-9]+)[fhd]?|[0-9]+[fhd]/),
        string: () => token(/"([^"\\\n]|\\.)*"/),
        identifier: () => /[A-Za-z_][A-Za-z0-9_]*/,
    },
});
