/**
 * The semantic graph of a specification as far as it is evaluated. Its classes are named as those of TLC's parser, SANY,
 * from whose graph {@link tla.tree.FromSany} takes it. {@link tla.tree.Kept} writes it to a file, from which it is read
 * much faster than SANY parses the modules.
 */
package tla.tree;
