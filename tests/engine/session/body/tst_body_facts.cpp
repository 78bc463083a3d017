#include "engine/session/facts/fact_codec.h"
#include "engine/session/facts/fact_rules.h"
#include "tests/engine/session/body/lived_body.h"
#include "tests/support/hex.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::body_facts_test
{

/// What facts about gas, drugs and tube look like as bytes.
class TestBodyFacts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesTheDocumentedBytes_data();
    void writesTheDocumentedBytes();
    void readsThemBack_data() { writesTheDocumentedBytes_data(); }
    void readsThemBack();
    void refusesEveryOtherLength_data() { writesTheDocumentedBytes_data(); }
    void refusesEveryOtherLength();
    void refusesWhatDoesNotExist_data();
    void refusesWhatDoesNotExist();
    void carriesACheckpointBitForBit();
    void acceptsNoSecondSpelling();
};

} // namespace carina::body_facts_test

namespace carina::body_facts_test
{

/// Zeros are f64 0, 3f f0 0... is 1, 40 00 0... is 2, 3f e0 0... is 1/2.
void TestBodyFacts::writesTheDocumentedBytes_data()
{
    QTest::addColumn<FactBody>("body");
    QTest::addColumn<QByteArray>("hex");
    const auto row = [](const char* name, const FactBody& body, const char* hex) {
        QTest::newRow(name) << body << QByteArray{hex};
    };
    row("gas", fact::GasSupplySet{{0.5, true, false}}, "28 000000000000e03f 01 00");
    row("drug", fact::DrugGiven{{DrugKind::Ephedrine, 2.0}}, "29 06 0000000000000040");
    row("cuff", fact::CuffSet{true}, "2a 01");
    row("stylet", fact::StyletDrawn{}, "2b");
    row("end of a try", fact::TryEnded{}, "30");
    row("kink", fact::TubeObstructed{0.5}, "2f 000000000000e03f");
    row("intubation",
        fact::IntubationNoted{{IntubationStep::PastCarina, SessionTime{Duration{0x0102}},
                               TubeSeat::LeftMain, 0.5, metres(1.0), metres(-0.5), metres(2.0),
                               0.25},
                              metres(0.5)},
        "2c 09 0201000000000000 03 000000000000e03f 000000000000f03f 000000000000e0bf"
        "0000000000000040 000000000000d03f 000000000000e03f");
}

void TestBodyFacts::writesTheDocumentedBytes()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, hex);
    QCOMPARE(toHex(encodeBody(body)), toHex(fromHex(hex)));
}

void TestBodyFacts::readsThemBack()
{
    QFETCH(const FactBody, body);
    QFETCH(const QByteArray, hex);
    QVERIFY(decodeBody(fromHex(hex)) == body);
}

void TestBodyFacts::refusesEveryOtherLength()
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

void TestBodyFacts::refusesWhatDoesNotExist_data()
{
    QTest::addColumn<QByteArray>("hex");
    const QByteArray zero = "0000000000000000";
    QTest::newRow("drug 7") << "2907" + zero;
    QTest::newRow("mask 2") << "28" + zero + "0200";
    QTest::newRow("cuff 2") << QByteArray{"2a02"};
    QTest::newRow("step 19") << "2c13" + zero + "00" + zero.repeated(6);
    QTest::newRow("seat 5") << "2c00" + zero + "05" + zero.repeated(6);
    QTest::newRow("dose not a number") << QByteArray{"2900000000000000f87f"};
}

void TestBodyFacts::refusesWhatDoesNotExist()
{
    QFETCH(const QByteArray, hex);
    QCOMPARE(decodeBody(fromHex(hex)).error().code, Errc::PacketMalformed);
}

void TestBodyFacts::carriesACheckpointBitForBit()
{
    const BodyState lived = test::livedBody();
    QVERIFY(lived.drugs[0].central_mg > 0.0);
    fact::BodyCheckpoint body{SessionTime{Duration{123456789}}, lived};
    body.state.capnograph = {};
    for (const FactBody& part :
         {FactBody{body}, FactBody{fact::CapnographCheckpoint{body.at, lived.capnograph}}}) {
        const std::vector<std::byte> bytes = encodeBody(part);
        QVERIFY(bytes.size() < kLargestFactBody);
        const Result<FactBody> read = decodeBody(bytes);
        QVERIFY(read == part);
        const Result<void> verdict = checkBody(*read);
        QVERIFY2(verdict, verdict ? "" : verdict.error().detail.c_str());
    }
}

void TestBodyFacts::acceptsNoSecondSpelling()
{
    constexpr int kMutants = 10000;
    std::mt19937 random{7};
    const std::vector<std::byte> seeds[] = {
        encodeBody(fact::BodyCheckpoint{SessionTime{}, test::livedBody()}),
        encodeBody(fact::CapnographCheckpoint{SessionTime{}, test::livedBody().capnograph}),
        encodeBody(fact::IntubationNoted{}), encodeBody(fact::GasSupplySet{}),
        encodeBody(fact::DrugGiven{})};
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
    QVERIFY(accepted > 500 && accepted < kMutants);
}

CARINA_TEST(TestBodyFacts)

} // namespace carina::body_facts_test

#include "tst_body_facts.moc"
