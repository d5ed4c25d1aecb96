package s7.log;

/**
 * The file that a header names as its profile: its text, or why it is missing.
 *
 * @param missing null if it is there
 */
public record ProfileFile(byte[] text, String missing) {}
