package s7.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import s7.log.Fields;

/**
 * Every outcome of a program, as a tree: {@code lines} that come one after the other, then the possible {@code ways},
 * each with the {@code choice} that leads there. A part that {@code goes_on} as the one of that number has none: from
 * there on everything is alike. Beside it is its {@code text}, lines for people.
 */
final class Outcomes {
  /** Places with a choice that a tree may have. */
  private static final int MOST = 500;

  private final Map<Object, Integer> known = new HashMap<>();
  private int parts;
  private int ends;

  private Outcomes() {}

  /**
   * The tree with the {@code header} of the logs and the number of {@code outcomes}; equal continuations count once.
   *
   * @throws NotCovered if there are too many, too
   */
  static Fields of(Simulation simulation) {
    var outcomes = new Outcomes();
    Fields tree = outcomes.part(simulation, 0);
    var text = new ArrayList<String>();
    write(text, tree, "");
    return new Fields()
        .put("header", simulation.header())
        .put("outcomes", outcomes.ends)
        .with(tree)
        .put("text", text);
  }

  /** A part in lines for people; a way is indented under the choice that leads there. */
  private static void write(List<String> text, Fields part, String indent) {
    for (Fields line : Work.objects(part.list("lines"))) {
      text.add(indent + line.text("at") + " " + Spelled.text(line));
    }
    List<Fields> ways = Work.objects(part.list("ways"));
    if (part.get("goes_on") != null) {
      text.add(indent + "goes on as at (" + part.get("goes_on") + ")");
    } else if (!ways.isEmpty()) {
      text.add(indent + "(" + part.get("number") + ") one of " + ways.size() + ":");
    }
    for (Fields way : ways) {
      text.add(indent + "  - " + way.text("choice"));
      write(text, way, indent + "    ");
    }
  }

  /** The part whose lines begin at a place. */
  private Fields part(Simulation simulation, int begin) {
    if (++parts > MOST) {
      throw new NotCovered("the program has more than " + MOST + " places with a choice: choose readings, or a seed");
    }
    Integer number = parts;
    List<Fields> choices = simulation.choices();
    for (; choices.size() == 1; choices = simulation.choices()) {
      simulation.take(choices.get(0));
    }
    Integer same = known.putIfAbsent(simulation.key(), number);
    var ways = new ArrayList<Fields>();
    for (Fields choice : same == null ? choices : List.<Fields>of()) {
      Simulation branch = simulation.branch();
      branch.take(choice);
      String name = choice == Simulation.NOTHING ? "it does not come" : Spelled.text(choice);
      ways.add(new Fields().put("choice", name).with(part(branch, simulation.size())));
    }
    ends += same == null && ways.isEmpty() ? 1 : 0;
    return new Fields()
        .put("number", number)
        .put("lines", simulation.shown(begin))
        .put("goes_on", same)
        .put("ways", ways);
  }
}
