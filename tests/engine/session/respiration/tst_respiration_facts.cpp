#include "engine/session/facts/fact_codec.h"
#include "engine/session/facts/fact_rules.h"
#include "tests/engine/session/respiration/lived_respiration.h"
#include "tests/support/hex.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::respiration_facts_test
{

/// What facts about respiration look like as bytes.
class TestRespirationFacts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesTheDocumentedBytes_data();
    void writesTheDocumentedBytes();
    void readsThemBack_data() { writesTheDocumentedBytes_data(); }
    void readsThemBack();
    void refusesEveryOtherLength_data() { writesTheDocumentedBytes_data(); }
    void refusesEveryOtherLength();
    void refusesEnumeratorsThatDoNotExist_data();
    void refusesEnumeratorsThatDoNotExist();
    void carriesACheckpointBitForBit();
    void acceptsNoSecondSpelling();
};

} // namespace carina::respiration_facts_test

namespace carina::respiration_facts_test
{

/// Zeros are f64 0, 3f f0 0... is 1, 40 00 0... is 2, 3f e0 0... is 1/2.
void TestRespirationFacts::writesTheDocumentedBytes_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("hex");
    const auto row = [](const char* name, const FactBody& body, const char* hex) {
        QTest::newRow(name) << body << QByteArray{hex};
    };
    row("patient", fact::PatientBuildSet{{metres(1.0), 2.0, 0.5, Sex::Male}},
        "0d 000000000000f03f 0000000000000040 000000000000e03f 01");
    row("no condition", fact::LungConditionsSet{}, "0e 00");
    row("condition",
        fact::LungConditionsSet{{{ConditionKind::StiffChest, 0.5, ConditionSide::Left}}},
        "0e 01 09 000000000000e03f 02");
    row("two conditions",
        fact::LungConditionsSet{{{ConditionKind::Copd, 1.0, ConditionSide::Both},
                                 {ConditionKind::SimplePneumothorax, 0.5, ConditionSide::Right}}},
        "0e 02 02 000000000000f03f 00 04 000000000000e03f 01");
    row("ventilator",
        fact::VentilatorSet{
            {VentilationMode::PressureControl, {1.0}, {2.0}, {0.5}, 0.5, {2.0}, hertz(1.0), 0.0}},
        "0f 02 000000000000f03f 0000000000000040 000000000000e03f 000000000000e03f"
        "0000000000000040 000000000000f03f 0000000000000000");
    row("tube", fact::TubePlaced{{TubeSeat::Oesophagus, metres(2.0)}}, "10 04 0000000000000040");
    row("position", fact::BodyPositionSet{BodyPosition::LeftLateral}, "13 04");
    row("stopped", fact::BreathingStopped{true, Duration{0x0102}}, "21 01 0201000000000000");
    row("bag", fact::BagSqueezed{{hertz(0.25), {1.0}}}, "22 000000000000d03f 000000000000f03f");
    row("breath", fact::ManikinBreathed{SessionTime{Duration{0x0102}}}, "11 0201000000000000");
}

void TestRespirationFacts::writesTheDocumentedBytes()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, hex);
    QCOMPARE(toHex(encodeBody(body)), toHex(fromHex(hex)));
}

void TestRespirationFacts::readsThemBack()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, hex);
    QVERIFY(decodeBody(fromHex(hex)) == body);
}

void TestRespirationFacts::refusesEveryOtherLength()
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

void TestRespirationFacts::refusesEnumeratorsThatDoNotExist_data()
{
    QTest::addColumn<QByteArray>("hex");
    const QByteArray zero = "0000000000000000";
    QTest::newRow("sex 2") << "0d" + zero + zero + zero + "02";
    QTest::newRow("condition 10") << "0e010a" + zero + "00";
    QTest::newRow("side 3") << "0e0101" + zero + "03";
    QTest::newRow("seven conditions") << "0e07" + ("01" + zero + "00").repeated(7);
    QTest::newRow("position 5") << QByteArray{"1305"};
    QTest::newRow("mode 3") << "0f03" + zero.repeated(7);
    QTest::newRow("time beyond 73 years") << QByteArray{"110100000000000020"};
    QTest::newRow("severity not a number") << QByteArray{"0e0101000000000000f87f00"};
}

void TestRespirationFacts::refusesEnumeratorsThatDoNotExist()
{
    QFETCH(const QByteArray, hex);
    QCOMPARE(decodeBody(fromHex(hex)).error().code, Errc::PacketMalformed);
}

/// 96 numbers of 8 bytes, two flags, and the kind: less than a fact may have.
void TestRespirationFacts::carriesACheckpointBitForBit()
{
    const fact::RespirationCheckpoint checkpoint{SessionTime{Duration{123456789}},
                                                 test::livedRespiration()};
    const std::vector<std::byte> bytes = encodeBody(checkpoint);
    QVERIFY(bytes.size() < kLargestFactBody);
    const Result<FactBody> read = decodeBody(bytes);
    QVERIFY(read.has_value());
    QVERIFY(std::get<fact::RespirationCheckpoint>(*read) == checkpoint);
    QVERIFY(std::get<fact::RespirationCheckpoint>(*read).state.content[1].trapped.si > 0.0);
    QVERIFY(checkBody(*read).has_value());
}

void TestRespirationFacts::acceptsNoSecondSpelling()
{
    constexpr int kMutants = 20000;
    std::mt19937 random{7};
    const std::vector<std::byte> seeds[] = {
        encodeBody(fact::RespirationCheckpoint{SessionTime{}, test::livedRespiration()}),
        encodeBody(fact::VentilatorSet{}),
        encodeBody(fact::LungConditionsSet{
            {{ConditionKind::Ards, 0.5, {}}, {ConditionKind::Atelectasis, 0.5, {}}}}),
        encodeBody(fact::PatientBuildSet{})};
    int accepted = 0;
    for (int i = 0; i < kMutants; ++i) {
        std::vector<std::byte> bytes = seeds[random() % std::size(seeds)];
        for (unsigned change = 0; change <= random() % 3; ++change)
            bytes[random() % bytes.size()] = static_cast<std::byte>(random() & 0xff);
        if (random() % 4 == 0)
            bytes.resize(random() % (bytes.size() + 1));
        const Result<FactBody> read = decodeBody(bytes);
        if (!read)
            continue;
        ++accepted;
        QCOMPARE(toHex(encodeBody(*read)), toHex(bytes));
    }
    QVERIFY(accepted > 1000 && accepted < kMutants);
}

CARINA_TEST(TestRespirationFacts)

} // namespace carina::respiration_facts_test

#include "tst_respiration_facts.moc"
