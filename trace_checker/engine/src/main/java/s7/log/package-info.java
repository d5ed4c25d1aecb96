/**
 * Reading of {@code s7-interrupt-log/1}: from bytes to normalised events, or to one clear error; also of programs of
 * the kit.
 *
 * <p>Nothing here knows the rules of an S7, only the form of a line. It is plain Java: no files, threads or reflection.
 */
package s7.log;
