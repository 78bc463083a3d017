#include "engine/session/facts/fact_codec.h"
#include "tests/support/hex.h"
#include "tests/support/test_class.h"

#include <limits>
#include <random>

namespace carina::fact_codec_test
{

/// The bytes were written down by hand from the layout in docs/protocol.md.
class TestFactCodec : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesTheDocumentedBytes_data();
    void writesTheDocumentedBytes();
    void readsThemBack_data() { writesTheDocumentedBytes_data(); }
    void readsThemBack();
    void refusesEveryOtherLength_data() { writesTheDocumentedBytes_data(); }
    void refusesEveryOtherLength();
    void refusesBadBytes_data();
    void refusesBadBytes();
    void acceptsNoSecondSpellingOfAFact();
    void carriesTheLongestText();
    void recordsCarryWhatIsAroundTheBody();
    void refusesAFactThatNoPatientCanHave();
    void refusesABrokenBodyInARecord();
};

} // namespace carina::fact_codec_test

namespace carina::fact_codec_test
{

namespace
{

struct Golden {
    const char* name;
    FactBody body;
    const char* hex;
};

std::vector<Golden> goldenFacts()
{
    return {
        {"session created", fact::SessionCreated{"Ab", "0f"}, "01 024162 023066"},
        {"phase changed", fact::PhaseChanged{SessionPhase::Ended}, "02 03"},
        {"station added", fact::StationAdded{"S"}, "03 0153"},
        {"participant joined",
         fact::ParticipantJoined{ParticipantId{0x1234}, Role::Observer, "Zo\xc3\xa9"},
         "04 3412 02 045a6fc3a9"},
        {"participant left", fact::ParticipantLeft{ParticipantId{0xff07}}, "05 07ff"},
        {"object shared",
         fact::ObjectShared{ObjectId{0x0102}, ParticipantId{3}, ObjectKind::Stylus, "t"},
         "06 0201 0300 03 0174"},
        {"anatomy chosen", fact::AnatomyChosen{"ab", "Adult"}, "07 026162 054164756c74"},
        {"breathing rate set", fact::BreathingRateSet{hertz(0.25)}, "08 000000000000d03f"},
        {"tidal volume set", fact::TidalVolumeSet{cubicMetres(-0.5)}, "09 000000000000e0bf"},
        {"inspiratory fraction set", fact::InspiratoryFractionSet{0.1}, "0a 9a9999999999b93f"},
        {"object handed over",
         fact::ObjectHandedOver{ObjectId{0x0102}, ParticipantId{0x0304}, 0x0506},
         "0b 0201 0403 0605"},
        {"object wanted", fact::ObjectWanted{ObjectId{0x0102}, true}, "0c 0201 01"},
        {"object not wanted any more", fact::ObjectWanted{ObjectId{0x0102}, false}, "0c 0201 00"},
        {"patient shared",
         fact::ObjectShared{ObjectId{1}, ParticipantId{2}, ObjectKind::Patient, ""},
         "06 0100 0200 04 00"},
        {"no names", fact::SessionCreated{}, "01 00 00"},
        {"participant muted", fact::ParticipantMuted{ParticipantId{0x0102}, true}, "14 0201 01"},
        {"participant removed", fact::ParticipantRemoved{ParticipantId{0x0102}, true, "no"},
         "15 0201 01 026e6f"},
        {"removed without a word", fact::ParticipantRemoved{ParticipantId{3}, false, {}},
         "15 0300 00 00"},
        {"ban lifted", fact::BanLifted{ParticipantId{0x0102}}, "16 0201"},
        {"session unlocked", fact::SessionLocked{false}, "17 00"},
        {"code changed", fact::RoleCodeChanged{Role::Observer}, "18 02"},
        {"token replaced", fact::TokenReplaced{ParticipantId{0x0102}}, "19 0201"},
        {"strategy chosen",
         fact::StrategyChosen{{StrategyKind::AsaFixed, {0x0102, 1.0, 0.5, 2.0}, Duration{0x0304}}},
         "1a 03 0201 000000000000f03f 000000000000e03f 0000000000000040 0403000000000000"},
        {"registration stated",
         fact::RegistrationStated{{RegistrationState::Stale, StaleReason::Drift, metres(0.5)}},
         "1b 04 0a 000000000000e03f"},
        {"no tracker any more",
         fact::RegistrationStated{{RegistrationState::NoTracker, StaleReason::None, {}}},
         "1b 06 00 0000000000000000"},
        {"station renamed", fact::StationRenamed{"S"}, "1c 0153"},
        {"station closed", fact::StationClosed{}, "1d"},
        {"participant moved", fact::ParticipantMoved{ParticipantId{0x0102}}, "1e 0201"},
        {"work taken", fact::WorkTaken{ParticipantId{0x0102}, ParticipantId{0x0304}},
         "1f 0201 0403"},
        {"work that nobody did", fact::WorkTaken{ParticipantId{2}, kNobody}, "1f 0200 ffff"},
        {"place chosen", fact::PlaceChosen{ParticipantId{0x0102}, radians(0.25)},
         "20 0201 000000000000d03f"},
        {"lesson shown",
         fact::LessonShown{ParticipantId{0x0102},
                           {{true, LessonCut::AllButAirway, {0.0, -1.0, 0.5}, 0.25},
                            true,
                            {{0x0102, 0x0304, LessonStyle::Hidden, false, true, true}}}},
         "23 0201 01 01 0000000000000000 000000000000f0bf 000000000000e03f 000000000000d03f 01"
         "01 0201 0403 03 00 01 01"},
        {"nothing but the usual shown to everybody", fact::LessonShown{},
         "23 ffff 00 00 0000000000000000 000000000000f03f 0000000000000000 0000000000000000 00"
         "00"},
        {"lesson ended", fact::LessonEnded{}, "24"},
        {"participant fell silent", fact::ParticipantFellSilent{ParticipantId{0x0102}}, "25 0201"},
        {"airway clear", fact::AirwayEventsSet{}, "26 00 0000000000000000"},
        {"airway events set",
         fact::AirwayEventsSet{
             {{AirwayEventKind::TongueOedema, 0.5}, {AirwayEventKind::Laryngospasm, 1.0}},
             Duration{0x0304}},
         "26 02 00 000000000000e03f 04 000000000000f03f 0403000000000000"},
        {"head in neutral position", fact::HeadPositionSet{},
         "27 0000000000000000 0000000000000000 0000000000000000"},
        {"head position set",
         fact::HeadPositionSet{{radians(0.5), radians(-0.125)}, Duration{0x0304}},
         "27 000000000000e03f 000000000000c0bf 0403000000000000"},
        {"pointer shared",
         fact::ObjectShared{ObjectId{1}, ParticipantId{2}, ObjectKind::Pointer, ""},
         "06 0100 0200 0a 00"},
        {"hand shared", fact::ObjectShared{ObjectId{1}, ParticipantId{2}, ObjectKind::Hand, ""},
         "06 0100 0200 05 00"},
        {"group of organs shared",
         fact::ObjectShared{ObjectId{1}, kNobody, ObjectKind::OrganGroup, "ab"},
         "06 0100 ffff 06 026162"},
        {"put back", fact::ObjectHandedOver{ObjectId{0x0102}, kNobody, 0x0506},
         "0b 0201 ffff 0605"},
    };
}

} // namespace

void TestFactCodec::writesTheDocumentedBytes_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("hex");
    for (const Golden& golden : goldenFacts())
        QTest::newRow(golden.name) << golden.body << QByteArray{golden.hex};
}

void TestFactCodec::writesTheDocumentedBytes()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, hex);
    QCOMPARE(toHex(encodeBody(body)), toHex(fromHex(hex)));
}

void TestFactCodec::readsThemBack()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, hex);
    const Result<FactBody> read = decodeBody(fromHex(hex));
    QVERIFY(read.has_value());
    QVERIFY(*read == body);
}

void TestFactCodec::refusesEveryOtherLength()
{
    QFETCH(const QByteArray, hex);
    std::vector<std::byte> bytes = fromHex(hex);
    bytes.push_back(std::byte{0});
    QCOMPARE(decodeBody(bytes).error().code, Errc::PacketMalformed);
    bytes.pop_back();
    while (!bytes.empty()) {
        bytes.pop_back();
        QCOMPARE(decodeBody(bytes).error().code, Errc::PacketMalformed);
    }
}

void TestFactCodec::refusesBadBytes_data()
{
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<QString>("detail");
    const auto row = [](const char* name, QByteArray hex, const char* detail) {
        QTest::newRow(name) << hex.replace(' ', "") << QString::fromUtf8(detail);
    };
    row("kind 0", "00", "kind of fact 0");
    row("kind 49", "31", "kind of fact 49");
    row("kind 255", "ff", "kind of fact 255");
    row("phase 4", "02 04", "fact of kind 2: enumerator");
    row("role 3", "04 0100 03 00", "fact of kind 4: enumerator");
    row("object kind 11", "06 0100 0100 0b 00", "fact of kind 6: enumerator");
    row("locked twice", "17 02", "fact of kind 23: flag");
    row("code of role 3", "18 03", "fact of kind 24: enumerator");
    row("airway event 24", "26 01 18 0000000000000000 0000000000000000",
        "fact of kind 38: enumerator");
    row("25 airway events", "26 19", "fact of kind 38: number of airway events");
    row("neck flexed without end", "27 000000000000f07f 0000000000000000 0000000000000000",
        "fact of kind 39: finite number");
    row("head not a number", "27 0000000000000000 000000000000f87f 0000000000000000",
        "fact of kind 39: finite number");
    row("wanted twice", "0c 0100 02", "fact of kind 12: flag");
    row("infinite rate", "08 000000000000f07f", "fact of kind 8: finite number");
    row("negative infinite volume", "09 000000000000f0ff", "fact of kind 9: finite number");
    row("fraction not a number", "0a 000000000000f87f", "fact of kind 10: finite number");
    const QByteArray cuts{"0000000000000000 000000000000f03f 0000000000000000 0000000000000000"};
    row("cut of 2", "23 ffff 01 02 " + cuts + " 00 00", "fact of kind 35: enumerator");
    row("style 4", "23 ffff 00 00 " + cuts + " 00 01 0100 0100 04 00 00 00",
        "fact of kind 35: enumerator");
    const QByteArray look{"0100 0100 00 00 00 00"};
    row("121 looks", "23 ffff 00 00 " + cuts + " 00 79" + look.repeated(121),
        "fact of kind 35: number of looks");
    row("standing 7", "1b 07 00 0000000000000000", "fact of kind 27: enumerator");
    row("stale by 11", "1b 04 0b 0000000000000000", "fact of kind 27: enumerator");
    row("text cut within a character", "03 01c3", "fact of kind 3: UTF-8");
    row("text with a surrogate", "03 03eda080", "fact of kind 3: UTF-8");
    row("text longer than the bytes", "03 ff41", "fact of kind 3: length");
    row("something left over", "05 0100 00", "fact of kind 5: length");
}

void TestFactCodec::refusesBadBytes()
{
    QFETCH(const QByteArray, hex);
    QFETCH(const QString, detail);
    const Result<FactBody> read = decodeBody(fromHex(hex));
    QVERIFY(!read);
    QCOMPARE(read.error().code, Errc::PacketMalformed);
    QCOMPARE(QString::fromStdString(read.error().detail), detail);
}

/// Bytes changed at random are refused or mean something else: what is accepted, encodes to the
/// same bytes again.
void TestFactCodec::acceptsNoSecondSpellingOfAFact()
{
    constexpr int kMutants = 20000;
    std::mt19937 random{7};
    const std::vector<Golden> seeds = goldenFacts();
    int accepted = 0;
    for (int i = 0; i < kMutants; ++i) {
        std::vector<std::byte> bytes = encodeBody(seeds[random() % seeds.size()].body);
        for (unsigned change = 0; change <= random() % 3; ++change) {
            const std::size_t place = random() % bytes.size();
            switch (random() % 3) {
            case 0:
                bytes[place] = static_cast<std::byte>(random() & 0xff);
                break;
            case 1:
                bytes.insert(bytes.begin() + std::ptrdiff_t(place), std::byte(random() & 0xff));
                break;
            default:
                bytes.resize(place + 1);
            }
        }
        const Result<FactBody> read = decodeBody(bytes);
        if (!read)
            continue;
        ++accepted;
        QCOMPARE(toHex(encodeBody(*read)), toHex(bytes));
    }
    QVERIFY(accepted > 1000 && accepted < kMutants);
}

void TestFactCodec::carriesTheLongestText()
{
    const FactBody body = fact::StationAdded{std::string(255, 'a')};
    const std::vector<std::byte> bytes = encodeBody(body);
    QCOMPARE(bytes.size(), std::size_t{257});
    QVERIFY(decodeBody(bytes) == body);
    const FactBody largest = fact::SessionCreated{std::string(255, 'a'), std::string(255, 'b')};
    QVERIFY(encodeBody(largest).size() <= kLargestFactBody);
}

void TestFactCodec::recordsCarryWhatIsAroundTheBody()
{
    const FactBody body = fact::ParticipantLeft{ParticipantId{2}};
    const Fact fact{FactNumber{11},
                    ProposalId{12},
                    ParticipantId{13},
                    StationId{14},
                    SessionTime{Duration{15}},
                    SessionTime{Duration{16}},
                    body};
    const FactRecord record = toRecord(fact);
    QVERIFY(
        (record
         == FactRecord{FactNumber{11}, ProposalId{12}, ParticipantId{13}, StationId{14},
                       SessionTime{Duration{15}}, SessionTime{Duration{16}}, fromHex("050200")}));
    QVERIFY(fromRecord(record) == fact);

    const Proposal proposal{ProposalId{21}, ParticipantId{22}, StationId{23}, body};
    const ProposalRecord proposed = toRecord(proposal);
    QVERIFY(
        (proposed
         == ProposalRecord{ProposalId{21}, ParticipantId{22}, StationId{23}, fromHex("050200")}));
    QVERIFY(fromRecord(proposed) == proposal);
}

void TestFactCodec::refusesAFactThatNoPatientCanHave()
{
    const FactBody tooFast = fact::BreathingRateSet{perMinute(61.0)};
    FactRecord record;
    record.body = encodeBody(tooFast);
    QCOMPARE(fromRecord(record).error().code, Errc::OutOfRange);
    // A proposal is judged by the host, which then tells its author why.
    ProposalRecord proposal;
    proposal.body = encodeBody(tooFast);
    QVERIFY(fromRecord(proposal).has_value());
}

void TestFactCodec::refusesABrokenBodyInARecord()
{
    FactRecord record;
    record.body = fromHex("0504");
    QCOMPARE(fromRecord(record).error().code, Errc::PacketMalformed);
    ProposalRecord proposal;
    proposal.body = fromHex("0504");
    QCOMPARE(fromRecord(proposal).error().code, Errc::PacketMalformed);
}

CARINA_TEST(TestFactCodec)

} // namespace carina::fact_codec_test

#include "tst_fact_codec.moc"
