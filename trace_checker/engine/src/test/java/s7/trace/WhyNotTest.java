package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import s7.log.Fields;
import tla.spec.Guards;

/** The sentence that says why a line is not possible. */
class WhyNotTest {
  private static final String TEXTS =
      """
      {"clauses": [
        {"id": "TINT-18", "text": "Monthly: the day of SDT is limited to 1 to 28. No limit in 1997 (AMB-05)."},
        {"id": "TINT-61", "text": "8090: bad OB_NR. 80A0: nothing is set. 80A1: the start has passed (for 0000. Once)."},
        {"id": "DINT-22", "text": "SIGN belongs to the program."},
        {"id": "OBS-22", "text": "A time error without OB 80: STOP, event 4568", "source": "all",
         "confidence": "H", "place": "requirements.md#OBS-22"},
        {"id": "AMB-12", "text": "Is it lost?", "letters": {"b": "It is not."}, "place": "readings.md#AMB-12"},
        {"id": "AMB-13", "text": "Is it late?", "letters": {"a": "yes", "b": "no"}},
        {"id": "OBS-01", "text": "See AMB-12."}],
       "events": {"4568": "STOP: OB 80 missing", "3502": "OB still in process"}}
      """;
  private final WhyNot why = new WhyNot(clauses());

  private static Clauses clauses() {
    var clauses = new Clauses();
    clauses.take(Fields.of(TEXTS.getBytes()));
    return clauses;
  }

  private static Explanation.Refusal refusal(boolean late, String expected, String rule) {
    List<Fields> events = Work.objects(object("{'all':[" + expected + "]}").list("all"));
    events.forEach(one -> one.put("text", Spelled.allowed(one)));
    Fields state =
        Fields.of(
            """
            {"mode":"RUN","clock":{"min":1,"ms":5},"running":[],"delay":0,"pending":[],"tod":[],"dint":[],"blocked":[],
             "silenced":[],"stop":-1,"kept":{"running":[],"delay":0,"pending":[],"dint":[]},"loaded":[1],"latency":10}
            """
                .replace("\n", "")
                .getBytes());
    var other = new Guards.Failure("Stop", "e.event = \"stop\"", "", "System:1", Set.of());
    var idle = new Guards.Failure("Start(OB 10)", "r \\in pending", "the set is empty", "Obs:2", Set.of("OBS-01"));
    var told = new Guards.Failure("EnAirt", "ret = delay", "ret = 1", "Airt:3", Set.of("AIRT-07"));
    var rules = new TreeSet<>(Set.of(rule, "ZZZ-01"));
    return new Explanation.Refusal(late, events, rules, 1, List.of(state), Set.of(other, idle, told));
  }

  @ParameterizedTest
  @DisplayName("what cannot be, the rule, what is instead")
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "{'event':'SET_TINT','ob':10,'ret':0} | {'event':'SET_TINT','ob':10,'field':'ret','value':32913} | TINT-18 |"
            + " SET_TINT cannot answer 16#0000 here. Monthly: the day of SDT is limited to 1 to 28 (TINT-18)."
            + " It answers 16#8091.",
        // Of a requirement with several sentences the one that has the code, 0000 last.
        "{'event':'ACT_TINT','ob':10,'ret':'W#16#0000'} | {'event':'ACT_TINT','ob':10,'field':'ret','value':32928},"
            + "{'event':'stop'} | TINT-61 | ACT_TINT cannot answer 16#0000 here. 80A0: nothing is set (TINT-61)."
            + " It answers 16#80A0.",
        "{'event':'ACT_TINT','ob':10,'ret':32928} | {'event':'ACT_TINT','ob':10,'field':'ret','value':0} | TINT-61 |"
            + " ACT_TINT cannot answer 16#80A0 here. 80A0: nothing is set (TINT-61). It answers 16#0000.",
        "{'event':'start','ob':20,'info':{'sign':8}} | {'event':'start','ob':20,'field':'sign','value':7} | DINT-22 |"
            + " start of OB 20 cannot have sign 16#0008 here. SIGN belongs to the program (DINT-22). It has 16#0007.",
        "{'event':'start','ob':10,'info':{'time':'2026-11-21T06:00'}} | {'event':'start','ob':10,'field':'time',"
            + "'time':{'min':1,'ms':0}} | DINT-22 | start of OB 10 cannot have time 2026-11-21T06:00 here. SIGN belongs"
            + " to the program (DINT-22). It has 1990-01-01T00:01:00.000.",
        "{'event':'diag','id':17768} | {'event':'stop'} | OBS-22 | The entry 16#4568 (STOP: OB 80 missing) cannot come"
            + " here. A time error without OB 80: STOP, event 4568 (OBS-22).",
        "{'event':'diag','id':'W#16#3502','info':{'ev_ob':10}} | {'event':'diag','ob':80,'field':'ev_ob','value':11} |"
            + " OBS-22 | The entry 16#3502 (OB still in process) cannot have ev_ob 10 here. A time error without OB 80:"
            + " STOP, event 4568 (OBS-22). It has 11.",
        "{'event':'stop','cause':'16#4568'} | {'event':'end'} | OBS-22 | The CPU cannot stop for 16#4568 (STOP: OB 80"
            + " missing) here. A time error without OB 80: STOP, event 4568 (OBS-22).",
        "{'event':'stop','cause':0} | {'event':'end'} | DINT-22 | The CPU cannot stop here. SIGN belongs to the program"
            + " (DINT-22).",
        "{'event':'restart','type':'warm'} | {'event':'end'} | DINT-22 | A warm restart cannot begin here. SIGN belongs"
            + " to the program (DINT-22).",
        "{'event':'start','ob':40} | {'event':'start','ob':80,'field':'flt_id','value':2} | DINT-22 | OB 40 cannot"
            + " start here. SIGN belongs to the program (DINT-22).",
        "{'event':'EN_AIRT','ret':0} | {'event':'end'} | DINT-22 | EN_AIRT cannot be called here. SIGN belongs to the"
            + " program (DINT-22).",
        // A field that is right is not the one that cannot be.
        "{'event':'start','ob':80,'info':{'flt_id':'B#16#02'}} | {'event':'start','ob':80,'field':'flt_id','value':2} |"
            + " DINT-22 | OB 80 cannot start here. SIGN belongs to the program (DINT-22).",
        "{'event':'end','ob':10} | {'event':'stop'} | AMB-13 | OB 10 cannot end here. The sources leave open: Is it"
            + " late? (AMB-13) a: yes; b: no.",
      })
  void sentence(String line, String expected, String rule, String said) {
    assertEquals(said, why.told(refusal(false, expected, rule), line.replace("'", "\"").getBytes()).text("why"));
  }

  @Test
  @DisplayName("what had to come before a line, with the words of its event ID")
  void late() {
    String expected = "{'event':'diag','field':'id','value':13570},{'event':'stop'}";
    Fields told = why.told(refusal(true, expected, "DINT-22"), new byte[0]);
    assertEquals(List.of("diag id=16#3502, within 10 ms", "stop, within 10 ms"), told.list("wanted"));
    assertEquals(
        "Before this line has to come: diag id=16#3502 (OB still in process), within 10 ms or stop, within 10 ms."
            + " SIGN belongs to the program (DINT-22).",
        told.text("why"));
    assertEquals(List.of(), told.list("formulas"));
  }

  @Test
  @DisplayName("what is expected is worded like the log, and formulas are those that are about the event")
  void words() {
    String values =
        "{'event':'EN_AIRT','ob':0,'field':'ret','value':0},{'event':'start','ob':80,'field':'flt_id','value':5},"
            + "{'event':'start','ob':40,'field':'flt_id','value':-1},{'event':'end','ob':10},"
            + "{'event':'start','field':'priority','value':2}";
    Fields told = why.told(refusal(false, values, "OBS-22"), "{\"event\":\"run\"}".getBytes());
    assertEquals(
        List.of("EN_AIRT ret=16#0000", "start ob=80 flt_id=16#05", "start ob=40", "end ob=10", "start priority=2"),
        told.list("wanted"));
    assertEquals(
        List.of(
            "EnAirt does not explain the line, since a condition is false: ret = delay;"
                + " here ret = 1 [AIRT-07, Airt:3]"),
        told.list("formulas"));
    assertEquals(
        "[expected, [EN_AIRT ret=16#0000, start ob=80 flt_id=16#05, start ob=40, end ob=10, start priority=2]]",
        told.list("decision").get(0).toString());
    assertEquals("[requirements, [OBS-22, ZZZ-01]]", told.list("decision").get(1).toString());
    assertEquals(
        List.of("OBS-22 A time error without OB 80: STOP, event 4568 (all, H; requirements.md#OBS-22)", "ZZZ-01 "),
        told.list("rules"));
    assertEquals(
        "[[before the line, [mode: RUN, clock 1990-01-01T00:01:00.005, running: nothing, loaded: OB 1]]]",
        told.list("before").toString());
    Fields state = (Fields) told.list("situations").get(0);
    assertEquals(List.of("mode", "RUN, clock 1990-01-01T00:01:00.005"), state.list("said").get(0));
  }

  @Test
  @DisplayName("other readings: those bear most that the rules name; those that were not asked are the same")
  void others() {
    String words =
        "{'families':['A','B'],'profiles':['2006'],'letters':[['AMB-12',['a','b']],['AMB-13',['a','b']],"
            + "['AMB-14',['a','b']]],'defaults':[['AMB-12','a'],['AMB-13','a'],['AMB-14','a']]}";
    String header = "{'cpu':'A','profile':'','readings':[]}";
    String rejected = "{'rules':['OBS-01','AMB-13'],'asked':['AMB-12','AMB-13']}";
    List<Fields> others = OtherHeaders.of(object(words), object(header), object(rejected), clauses());
    assertEquals(
        List.of("cpu B 2 false", "profile 2006 2 false", "AMB-12 b 1 false", "AMB-13 b 0 false", "AMB-14 b 3 true"),
        others.stream().map(one -> one.text("change") + " " + one.get("distance") + " " + one.get("same")).toList());
  }

  @Test
  @DisplayName("the verdicts under other readings are told in groups")
  void told() {
    String tried =
        "'tried':[{'kind':'cpu','change':'cpu B','verdict':'rejected','line':9},{'kind':'letter','change':'AMB-12 b',"
            + "'verdict':'accepted'},{'kind':'profile','change':'no profile','verdict':'no verdict','line':3}]}";
    Fields message = object("{'verdict':'rejected','line':5,'untried':['AMB-13 b'],'remedy':' (x)'," + tried);
    assertEquals(
        "[[would pass with, [AMB-12 b: Is it lost? It is not. (readings.md#AMB-12)]],"
            + " [would get further with, [cpu B at line 9]], [not tried for lack of time, [AMB-13 b (x)]]]",
        OtherHeaders.told(message, clauses()).toString());
    assertEquals(
        "[[also accepted by, [1 of 3 other readings]], [rejected by,"
            + " [cpu B at line 9, no profile no verdict at line 3]]]",
        OtherHeaders.told(object("{'verdict':'accepted','line':null," + tried), clauses()).toString());
    assertEquals(
        "[[would pass with, [no other reading that was tried]]]",
        OtherHeaders.told(object("{'verdict':'rejected','line':5,'tried':[]}"), clauses()).toString());
  }

  private static Fields object(String text) {
    return Fields.of(text.replace("'", "\"").getBytes());
  }
}
