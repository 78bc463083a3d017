#include "engine/net/entry/role_proof.h"
#include "tests/support/test_class.h"

#include <numeric>
#include <random>

namespace carina::role_proof_test
{
namespace
{

const std::string kSession = "00112233445566778899aabbccddeeff";

/// 32 bytes that count up from the first.
AccessKey countingFrom(int first)
{
    AccessKey bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(static_cast<std::size_t>(first) + i);
    return bytes;
}

PskIdentity anna() { return {{Role::Trainee, ParticipantId{7}}, kSession}; }

RoleProof annasProof()
{
    return proveRole(anna(), countingFrom(0), countingFrom(0x20), countingFrom(0x40));
}

std::vector<std::byte> withByte(std::vector<std::byte> bytes, std::size_t at, int value)
{
    bytes[at] = static_cast<std::byte>(value);
    return bytes;
}

} // namespace

class TestRoleProof : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void macIsThatOfRfc2104()
    {
        // Python 3.11: hmac.new(r(0), b"carina role proof 1" + r(32) + r(64)
        //     + b"trainee:00112233445566778899aabbccddeeff:7", "sha256").hexdigest()
        // with r = lambda first: bytes(range(first, first + 32)).
        QCOMPARE(toHex(annasProof().mac),
                 std::string{"deffdccb419063934017a549d48dd71260f57924d94e972fc3b2f37f2d60ad63"});
        QVERIFY(annasProof().identity == anna());
    }

    void provesThisRoleByThisKeyToThisHostOnce()
    {
        const auto holds = [](const RoleProof& proof, int key, int nonce, int host) {
            return isProvedBy(proof, countingFrom(key), countingFrom(nonce), countingFrom(host));
        };
        QVERIFY(holds(annasProof(), 0, 0x20, 0x40));
        QVERIFY(!holds(annasProof(), 1, 0x20, 0x40));
        QVERIFY(!holds(annasProof(), 0, 0x21, 0x40));
        QVERIFY(!holds(annasProof(), 0, 0x20, 0x41));
        RoleProof promoted = annasProof();
        promoted.identity.who.role = Role::Instructor;
        QVERIFY(!holds(promoted, 0, 0x20, 0x40));
        RoleProof somebodyElse = annasProof();
        somebodyElse.identity.who.participant = ParticipantId{8};
        QVERIFY(!holds(somebodyElse, 0, 0x20, 0x40));
        for (const std::size_t at : {std::size_t{0}, std::size_t{31}}) {
            RoleProof changed = annasProof();
            changed.mac[at] ^= std::byte{1};
            QVERIFY(!holds(changed, 0, 0x20, 0x40));
        }
    }

    void challengeIsWrittenAndRead()
    {
        const RoleChallenge challenge{kSession, countingFrom(0x20)};
        const auto bytes = encodeChallenge(challenge);
        QCOMPARE(bytes.size(), std::size_t{4 + 32 + 32});
        QVERIFY(decodeChallenge(bytes) == challenge);
        QVERIFY(!decodeProof(bytes) && !decodeVerdict(bytes));
        QVERIFY(!decodeChallenge(std::span{bytes}.first(bytes.size() - 1)));
        QVERIFY(!decodeChallenge(withByte(bytes, 4, 'G')));
        auto longer = bytes;
        longer.push_back(std::byte{0});
        QVERIFY(!decodeChallenge(longer));
    }

    void proofIsWrittenAndRead()
    {
        const auto bytes = encodeProof(annasProof());
        QCOMPARE(bytes.size(), 4 + 32 + toText(anna()).size());
        QVERIFY(decodeProof(bytes) == annasProof());
        QVERIFY(!decodeChallenge(bytes) && !decodeVerdict(bytes));
        QVERIFY(!decodeProof(std::span{bytes}.first(36)));
        QVERIFY(!decodeProof(std::span{bytes}.first(35)));
        QVERIFY(!decodeProof(std::span{bytes}.first(bytes.size() - 1)));
        for (const std::size_t at : {0, 1, 2, 3})
            QVERIFY(!decodeProof(withByte(bytes, at, 9)));
    }

    void verdictIsWrittenAndRead()
    {
        QVERIFY(decodeVerdict(encodeVerdict(true)) == true);
        QVERIFY(decodeVerdict(encodeVerdict(false)) == false);
        QVERIFY(!decodeVerdict({}));
        auto longer = encodeVerdict(true);
        longer.push_back(std::byte{0});
        QVERIFY(!decodeVerdict(longer));
    }

    void mutatedDatagramsAreRefusedOrSound()
    {
        std::mt19937 random{7};
        int accepted = 0;
        for (int i = 0; i < 100'000; ++i) {
            auto bytes = i % 2 == 0 ? encodeProof(annasProof())
                                    : encodeChallenge({kSession, countingFrom(0x20)});
            bytes[random() % bytes.size()] = static_cast<std::byte>(random() % 256);
            if (random() % 4 == 0)
                bytes.resize(random() % (bytes.size() + 1));
            if (const auto proof = decodeProof(bytes)) {
                ++accepted;
                QVERIFY(encodeProof(*proof) == bytes);
            }
            if (const auto challenge = decodeChallenge(bytes)) {
                ++accepted;
                QVERIFY(encodeChallenge(*challenge) == bytes);
            }
        }
        QVERIFY(accepted > 1000);
        QVERIFY(accepted < 90'000);
    }
};

CARINA_TEST(TestRoleProof)

} // namespace carina::role_proof_test

#include "tst_role_proof.moc"
