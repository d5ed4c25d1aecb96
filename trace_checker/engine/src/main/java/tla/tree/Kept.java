package tla.tree;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.function.Supplier;

import util.UniqueString;

/**
 * A graph in bytes, with the texts of its modules. Names and definitions are read at once, the body of a definition when
 * it is first needed, texts and the location of a node when a report needs them.
 */
public final class Kept {
  /** Another number for each form of such bytes. */
  static final int FORM = 3;

  static final int DEFINITION = 0;
  static final int PARAMETER = 1;
  static final int DECLARED = 2;

  static final int NOTHING = 0;
  static final int NUMERAL = 1;
  static final int STRING = 2;
  static final int AT = 3;
  static final int OPERATOR = 4;
  static final int LET = 5;
  static final int APPLICATION = 6;
  static final int OTHER = 7;
  static final int KINDS = 7;
  static final int ACTION = 8;
  static final int MARKED = 16;
  static final int COMPONENT = 32;
  static final int BINDS = 64;

  /** Bytes of a location. */
  private static final int LOCATION = 10;

  /** Bytes of the sum over all that comes after it. */
  private static final int SUM = 4;

  private final byte[] bytes;
  private int at = SUM;
  private UniqueString[] strings;
  private OpDeclNode[] declared;
  private FormalParamNode[] parameters;
  private OpApplNode[] components;
  private OpDefNode[] definitions;
  private int bodies;
  private int locations;

  private Kept(byte[] bytes) {
    this.bytes = bytes;
  }

  /** A graph with the texts of its modules. */
  public static byte[] bytes(Module module) {
    return Keeping.bytes(module);
  }

  /** The graph; null if these are not the bytes of one. */
  public static Module read(byte[] bytes) {
    try {
      return new Kept(bytes).module();
    } catch (RuntimeException e) {
      return null;
    }
  }

  private Module module() {
    if (ByteBuffer.wrap(bytes).getInt() != sum(bytes, SUM) || number() != FORM) {
      throw new IllegalArgumentException("damaged, or of another form");
    }
    strings = new UniqueString[number()];
    for (int i = 0; i < strings.length; i++) {
      int length = number();
      strings[i] = UniqueString.uniqueStringOf(new String(bytes, at, length, StandardCharsets.UTF_8));
      at += length;
    }
    declared = new OpDeclNode[number()];
    int variables = number();
    for (int i = 0; i < declared.length; i++) {
      String name = strings[number()].toString();
      declared[i] = new OpDeclNode(place(number()), name);
    }
    parameters = new FormalParamNode[number()];
    for (int i = 0; i < parameters.length; i++) {
      String name = strings[number()].toString();
      parameters[i] = new FormalParamNode(place(number()), name);
    }
    components = new OpApplNode[number()];
    definitions = new OpDefNode[number()];
    int top = number();
    for (int i = 0; i < definitions.length; i++) {
      definitions[i] = definition();
    }
    var texts = new HashMap<String, Supplier<String>>();
    var module = new Module(texts, Arrays.copyOf(declared, variables), Arrays.copyOf(definitions, top));
    marks(module);
    for (int i = number(); i > 0; i--) {
      String name = strings[number()].toString();
      int length = number();
      int from = at;
      texts.put(name, () -> new String(bytes, from, length, StandardCharsets.UTF_8));
      at += length;
    }
    int length = number();
    bodies = at;
    locations = at + length;
    return module;
  }

  /** A sum over the bytes from a place on, by which damage shows. */
  static int sum(byte[] bytes, int from) {
    int sum = 0;
    for (int i = from; i < bytes.length; i++) {
      sum = 31 * sum + bytes[i];
    }
    return sum;
  }

  private OpDefNode definition() {
    String name = strings[number()].toString();
    SemanticNode.Place place = place(number());
    int flags = number();
    int mark = number() - 1;
    var its = new FormalParamNode[number()];
    for (int i = 0; i < its.length; i++) {
      its[i] = parameters[number()];
    }
    var definition = new OpDefNode(place, name, (flags & 2) != 0, (flags & 4) != 0, its);
    definition.mark = mark;
    if ((flags & 1) != 0) {
      int from = number();
      int first = number();
      definition.hasBody(() -> body(from, first));
    }
    return definition;
  }

  private void marks(Module module) {
    var names = new HashSet<String>();
    for (int i = number(); i > 0; i--) {
      names.add(strings[number()].toString());
    }
    var marked = new ArrayList<Module.Marked>();
    for (int i = number(); i > 0; i--) {
      int kind = number();
      OpDefNode definition = definitions[number()];
      int place = number();
      SemanticNode node = place == 0 ? definition : new OtherNode(place(place - 1), "marked");
      marked.add(new Module.Marked(kind, definition, node));
    }
    module.has(names, marked);
  }

  private int number() {
    int number = 0;
    for (int shift = 0; ; shift += 7) {
      int next = bytes[at++];
      number |= (next & 0x7F) << shift;
      if (next >= 0) {
        return number;
      }
    }
  }

  private SemanticNode.Place place(int number) {
    return () -> {
      int from = locations + LOCATION * number;
      return new Location(
          strings[short16(from)].toString(),
          short16(from + 2),
          short16(from + 4),
          short16(from + 6),
          short16(from + 8));
    };
  }

  private int short16(int from) {
    return (bytes[from] & 0xFF) << 8 | bytes[from + 1] & 0xFF;
  }

  /** Reads one body after the other, so that none is read inside another. */
  private ExprNode body(int from, int first) {
    at = bodies + from;
    return (ExprNode) new Body(first).node();
  }

  private SymbolNode symbol() {
    int number = number();
    return switch (number & 3) {
      case DEFINITION -> definitions[number >> 2];
      case PARAMETER -> parameters[number >> 2];
      default -> declared[number >> 2];
    };
  }

  /** A body: its nodes have the numbers of their places in their order. */
  private final class Body {
    private int next;

    Body(int first) {
      next = first;
    }

    ExprOrOpArgNode node() {
      int kind = bytes[at++];
      if (kind == NOTHING) {
        return null;
      }
      SemanticNode.Place place = place(next++);
      int mark = (kind & MARKED) == 0 ? SemanticNode.UNMARKED : number();
      boolean action = (kind & ACTION) != 0;
      ExprOrOpArgNode node =
          switch (kind & KINDS) {
            case NUMERAL -> new NumeralNode(place, number());
            case STRING -> new StringNode(place, strings[number()]);
            case AT -> new AtNode(place, components[number()]);
            case OPERATOR -> new OpArgNode(place, symbol());
            case LET -> let(new LetInNode(place, action));
            case APPLICATION -> application(new OpApplNode(place, action), kind);
            default -> new OtherNode(place, strings[number()].toString());
          };
      node.mark = mark;
      return node;
    }

    private LetInNode let(LetInNode let) {
      var lets = new OpDefNode[number()];
      for (int i = 0; i < lets.length; i++) {
        lets[i] = definitions[number()];
      }
      let.has(lets, (ExprNode) node());
      return let;
    }

    private OpApplNode application(OpApplNode apply, int kind) {
      if ((kind & COMPONENT) != 0) {
        components[number()] = apply;
      }
      SymbolNode operator = symbol();
      if ((kind & BINDS) != 0) {
        var bounds = new ExprNode[number()];
        var symbols = new FormalParamNode[bounds.length][];
        var tuples = new boolean[bounds.length];
        for (int i = 0; i < bounds.length; i++) {
          tuples[i] = bytes[at++] != 0;
          symbols[i] = new FormalParamNode[number()];
          for (int k = 0; k < symbols[i].length; k++) {
            symbols[i][k] = parameters[number()];
          }
          bounds[i] = (ExprNode) node();
        }
        apply.binds(symbols, bounds, tuples);
      }
      var arguments = new ExprOrOpArgNode[number()];
      for (int i = 0; i < arguments.length; i++) {
        arguments[i] = node();
      }
      apply.applies(operator, arguments);
      return apply;
    }
  }
}
