package s7.importing;

import java.util.ArrayList;
import java.util.List;

import s7.log.Unusable;

/** Rows of comma-separated values, in which a cell may stand in quotation marks, doubled where they mean themselves. */
final class Csv {
  private final String text;
  private final char delimiter;
  private int at;
  private int line;

  /**
   * @param delimiter stands between two cells
   */
  Csv(String text, char delimiter) {
    this.text = text;
    this.delimiter = delimiter;
  }

  /** The number of the last line of the row that was read last, from 1. */
  int line() {
    return line;
  }

  /** The cells of the next row, none for an empty line; null at the end. */
  List<String> next() {
    if (at >= text.length()) {
      return null;
    }
    var cells = new ArrayList<String>();
    line++;
    if (isEnd(at)) {
      passEnd();
      return cells;
    }
    do {
      cells.add(text.startsWith("\"", at) ? quoted() : plain());
    } while (more());
    passEnd();
    return cells;
  }

  private String plain() {
    int begin = at;
    while (at < text.length() && text.charAt(at) != delimiter && !isEnd(at)) {
      at++;
    }
    return text.substring(begin, at);
  }

  private String quoted() {
    var cell = new StringBuilder();
    at++;
    while (true) {
      if (at >= text.length()) {
        throw wrong("unexpected end of data");
      }
      char c = text.charAt(at++);
      if (c == '"' && (at >= text.length() || text.charAt(at) != '"')) {
        break;
      }
      if (c == '\n' || (c == '\r' && !text.startsWith("\n", at))) {
        line++;
      }
      cell.append(c);
      at += c == '"' ? 1 : 0;
    }
    if (at < text.length() && text.charAt(at) != delimiter && !isEnd(at)) {
      throw wrong("'" + delimiter + "' expected after '\"'");
    }
    return cell.toString();
  }

  /** Passes a delimiter; an empty cell may end the text. */
  private boolean more() {
    if (at >= text.length() || text.charAt(at) != delimiter) {
      return false;
    }
    at++;
    return true;
  }

  private Unusable wrong(String found) {
    return new Unusable("CSV", found).of("line " + line);
  }

  private boolean isEnd(int place) {
    return text.charAt(place) == '\n' || text.charAt(place) == '\r';
  }

  private void passEnd() {
    at += text.startsWith("\r\n", at) ? 2 : 1;
  }
}
