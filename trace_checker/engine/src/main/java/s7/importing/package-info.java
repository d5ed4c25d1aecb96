/**
 * Importing: from the records of a CPU or a program to a log of {@code s7-interrupt-log/1}.
 *
 * <p>Each source is read by a class of its own into a {@link s7.importing.Recording}, events with the place they come
 * from; facts that a source does not tell stay unrecorded. What cannot be read is {@link s7.log.Unusable}.
 */
package s7.importing;
