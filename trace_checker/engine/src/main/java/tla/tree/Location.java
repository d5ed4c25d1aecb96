package tla.tree;

/**
 * Where a node stands in the text of the specification.
 *
 * @param source the module
 * @param beginLine counted from 1, as all of them
 */
public record Location(String source, int beginLine, int beginColumn, int endLine, int endColumn) {}
