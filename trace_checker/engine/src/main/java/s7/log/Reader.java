package s7.log;

/** Turns a decoded JSON value into the normalised one. */
interface Reader {
  /**
   * The normalised value.
   *
   * @throws Unusable without the field, if it is another kind of value
   */
  Object read(Object value);
}
