package s7.log;

/** A number that is no integer of 64 bits, as it was written. */
record JsonNumber(String text, boolean isInteger) {
  @Override
  public String toString() {
    return text;
  }
}
