#pragma once

#include "engine/sync/wire/datagram.h"
#include "tests/support/hex.h"

namespace carina
{

/// One record or header and its bytes, worked out by hand from the tables in docs/protocol.md.
struct GoldenRecord {
    const char* name;
    WireRecord record;
    const char* hex;
};

inline BundleHeader goldenHeader()
{
    BundleHeader header;
    header.fromHost = true;
    header.connection = 0x11223344;
    header.sequence = 0x55667788;
    header.sender = ParticipantId{0x0201};
    header.sentAt = Duration{0x0102030405060708};
    header.echo = ClockEcho{Duration{-2}, Duration{0xFFFFFFFF}};
    return header;
}

inline constexpr const char* kGoldenHeaderHex =
    "43 41 14 03  44 33 22 11  88 77 66 55  01 02  08 07 06 05 04 03 02 01"
    "fe ff ff ff ff ff ff ff  ff ff ff ff";

inline constexpr const char* kPlainHeaderHex =
    "43 41 14 00  01 00 00 00  02 00 00 00  ff ff  00 00 00 00 00 00 00 00"
    "00 00 00 00 00 00 00 00  00 00 00 00";

/// A quarter turn about z at (0.1, -0.2, 0.3) m, 2^32 + 5 us after the epoch.
inline StreamCpo goldenStream()
{
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    StreamCpo stream;
    stream.object = ObjectId{0x0102};
    stream.sequence = 0x0304;
    stream.time = SessionTime{std::chrono::microseconds{0x1'0000'0005}};
    stream.X_AO = RigidTransform{Quat{1.0, 0.0, 0.0, 1.0}, Vec3{0.1, -0.2, 0.3}};
    stream.motion = StreamMotion{Vec3{1.0, -0.5, 0.0}, Vec3{90.0, -0.02, 0.0} * kDegree};
    stream.validity = StreamValidity::PartlyOccluded;
    stream.error = 0.001;
    return stream;
}

/// The same, and it bends, as it did 20 ms before.
inline StreamCpo goldenBentStream()
{
    StreamCpo stream = goldenStream();
    stream.shape = StreamShape{
        stream.time - std::chrono::milliseconds{20},           0.3,   0.0089, {7.0, -7.0},
        {1.0, -2.0, 0.002, 65.534, -65.534, 0.0, 4.0, -0.002}, 0.0123};
    return stream;
}

/// The tube that the patient has bends in the same way.
inline StreamCpo goldenPatientsTube()
{
    StreamCpo stream = goldenBentStream();
    stream.shape->length = 0.0;
    stream.shape->thickness = 0.0;
    stream.shape->atRest = {};
    return stream;
}

/// At rest and unturned 7 us before the other, lost, its motion unknown.
inline StreamCpo goldenLostStream()
{
    StreamCpo stream;
    stream.object = ObjectId{7};
    stream.sequence = 0xFFFF;
    stream.time = SessionTime{std::chrono::microseconds{0xFFFF'FFFE}};
    stream.validity = StreamValidity::Lost;
    return stream;
}

inline EventCpo goldenEvent()
{
    EventCpo event;
    event.object = ObjectId{0x0102};
    event.epoch = 3;
    event.action = 0x01020304;
    event.kind = ActionKind::Scaling;
    event.start = SessionTime{Duration{-1}};
    event.q_AO = Quat{0.0, 1.0, 0.0, 0.0};
    event.p_AO = Vec3{1.0, -2.0, 0.5};
    event.axis_A = Vec3f{0.0F, -1.0F, 0.0F};
    event.rate = 1.5F;
    event.scale = 2.0F;
    return event;
}

inline FactRecord goldenFact()
{
    return {FactNumber{0x0102030405060708},
            ProposalId{0x1112131415161718},
            ParticipantId{0x0102},
            StationId{0x0304},
            SessionTime{Duration{1}},
            SessionTime{Duration{256}},
            fromHex("aa bb cc")};
}

inline ProposalRecord goldenProposal()
{
    return {ProposalId{0x1112131415161718}, kNobody, StationId{0x0304}, fromHex("aa bb")};
}

inline SessionKey goldenKey()
{
    SessionKey key{};
    for (std::size_t i = 0; i < key.size(); ++i)
        key[i] = static_cast<std::byte>(0xA0 + i);
    return key;
}

inline std::vector<GoldenRecord> goldenRecords()
{
    const StreamGroup group{
        ParticipantId{2}, 0x0405, StationId{6}, {goldenStream(), goldenLostStream()}};
    return {
        {"stream group", group,
         "01  02 00  05 04  06 00  01 00 00 00  02"
         "02 01  04 03  16  14  05 00 00 00  00 00 00 00 ff 7f  10 27 00 e0 b1 ff 30 75 00"
         "10 27 78 ec 00 00  94 11 ff ff 00 00"
         "07 00  ff ff  0b  00  fe ff ff ff  00 00 00 00 00 00  00 00 00 00 00 00 00 00 00"
         "00 00 00 00 00 00  00 00 00 00 00 00"},
        {"event", goldenEvent(),
         "02  02 01  03 00  04 03 02 01  02  ff ff ff ff ff ff ff ff"
         "00 00 00 00 00 00 f0 3f  00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00"
         "00 00 00 00 00 00 00 00"
         "00 00 00 00 00 00 f0 3f  00 00 00 00 00 00 00 c0  00 00 00 00 00 00 e0 3f"
         "00 00 00 00  00 00 80 bf  00 00 00 00  00 00 c0 3f  00 00 00 40"},
        {"fact", goldenFact(),
         "03  08 07 06 05 04 03 02 01  18 17 16 15 14 13 12 11  02 01  04 03"
         "01 00 00 00 00 00 00 00  00 01 00 00 00 00 00 00  03 00 aa bb cc"},
        {"proposal", goldenProposal(), "04  18 17 16 15 14 13 12 11  04 03  02 00 aa bb"},
        {"acknowledgement", FactAck{FactNumber{0x0102}}, "05  02 01 00 00 00 00 00 00"},
        {"refusal", ProposalRefused{ProposalId{3}, Errc::NotPermitted},
         "06  03 00 00 00 00 00 00 00  01"},
        {"hello", Hello{goldenKey(), FactNumber{9}, goldenProposal()},
         "07  a0 a1 a2 a3 a4 a5 a6 a7 a8 a9 aa ab ac ad ae af  09 00 00 00 00 00 00 00"
         "18 17 16 15 14 13 12 11  04 03  02 00 aa bb  00"},
        {"welcome", Welcome{goldenKey(), ParticipantId{5}, 0x0203, FactNumber{10}},
         "08  a0 a1 a2 a3 a4 a5 a6 a7 a8 a9 aa ab ac ad ae af  05 00  03 02"
         "0a 00 00 00 00 00 00 00"},
        {"hello refused", HelloRefused{Errc::VersionMismatch, {}}, "09  07 00"},
        {"hello refused with words", HelloRefused{Errc::Removed, "no"}, "09  0e 02 6e 6f"},
        {"connection unknown", ConnectionUnknown{}, "0a"},
        {"goodbye", Goodbye{}, "0b"},
        {"event acknowledgement", EventAck{ObjectId{0x0102}, 0x0304, 0x05060708},
         "0c  02 01  04 03  08 07 06 05"},
        {"event beat", EventBeat{ObjectId{0x0102}, 0x0304, 0x05060708},
         "0d  02 01  04 03  08 07 06 05"},
        {"message of the strategy",
         StrategyMessage{StrategyKind::Event, {std::byte{0xaa}, std::byte{0xbb}, std::byte{0xcc}}},
         "0e  06  03  aa bb cc"},
        {"needed lag", LagNeeded{Duration{0x01020304}}, "0f  04 03 02 01"},
        {"shown pose",
         ShownPose{ObjectId{0x0102}, SessionTime{Duration{0x0304}},
                   RigidTransform{Quat{0.0, 1.0, 0.0, 0.0}, Vec3{1.0, 2.0, -0.5}}, 2.0},
         "10  02 01  04 03 00 00 00 00 00 00"
         "00 00 00 00 00 00 f0 3f  00 00 00 00 00 00 00 00"
         "00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00"
         "00 00 00 00 00 00 f0 3f  00 00 00 00 00 00 00 40  00 00 00 00 00 00 e0 bf"
         "00 00 00 40"},
        {"external time", ExternalTimeRecord{{Duration{0x0102030405060708}, Duration{0x01020304}}},
         "11  08 07 06 05 04 03 02 01  04 03 02 01 00 00 00 00"},
        {"hello to a station", Hello{goldenKey(), FactNumber{9}, goldenProposal(), "R5"},
         "07  a0 a1 a2 a3 a4 a5 a6 a7 a8 a9 aa ab ac ad ae af  09 00 00 00 00 00 00 00"
         "18 17 16 15 14 13 12 11  04 03  02 00 aa bb  02 52 35"},
        {"stream group with a form",
         StreamGroup{ParticipantId{2}, 0x0405, StationId{6}, {goldenBentStream()}},
         "01  02 00  05 04  06 00  01 00 00 00  01"
         "02 01  04 03  36  14  05 00 00 00  00 00 00 00 ff 7f  10 27 00 e0 b1 ff 30 75 00"
         "10 27 78 ec 00 00  94 11 ff ff 00 00"
         "14  59  30 75  ac 0d 54 f2  f4 01 18 fc 01 00 ff 7f 01 80 00 00 d0 07 ff ff  ce 04"},
        {"stream group with the form of the patient's tube",
         StreamGroup{ParticipantId{2}, 0x0405, StationId{6}, {goldenPatientsTube()}},
         "01  02 00  05 04  06 00  01 00 00 00  01"
         "02 01  04 03  36  14  05 00 00 00  00 00 00 00 ff 7f  10 27 00 e0 b1 ff 30 75 00"
         "10 27 78 ec 00 00  94 11 ff ff 00 00"
         "14  00  00 00  00 00 00 00  f4 01 18 fc 01 00 ff 7f 01 80 00 00 d0 07 ff ff  ce 04"},
    };
}

} // namespace carina
