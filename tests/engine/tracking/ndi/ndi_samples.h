#pragma once

#include "engine/tracking/ndi/ndi_frame.h"
#include "tests/engine/tracking/ndi/wire_bytes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace carina::test
{

/// Whole inputs of the decoders of NDI.
struct NdiSample {
    /// What reads it.
    enum class Reader : std::uint8_t { Tx, Bx, Bx2, Stream, Recording };

    Reader reader = Reader::Tx;
    std::uint16_t options = 0; ///< of TX and BX; the pieces in which a stream comes
    std::string bytes{};
};

/// Recorded from a Polaris: handle 01 at frame 0x3AD.
inline const std::string kRecordedTx = "0101+07003+07110-00250+00572-021400+009890-158180+01106"
                                       "00000031000003AD\n0000";
/// Recorded: a whole reply to BX with two tools, both missing.
inline const std::string kRecordedBxHeader{"\xC4\xA5\x17\x00\"\xE3", 6};
inline const std::string kRecordedBx{
    "\x02\x01\x02\x31\x00\x00\x00\x00\x00\x00\x00\x02\x02\x31\x00\x00\x00\x00"
    "\x00\x00\x00\x00\x00",
    23};
inline const std::string kRecordedBxChecksum = "\xB1\x37";

/// In BX and BX2: half a turn about y, 1.5 m before the tracker.
inline WireBytes wirePose()
{
    WireBytes pose;
    for (const float part : {0.0F, 0.0F, 1.0F, 0.0F, 10.0F, -20.0F, -1500.0F, 0.25F})
        pose.real(part);
    return pose;
}

inline WireBytes bx2Component(std::uint32_t type, std::uint32_t count, const WireBytes& items)
{
    return WireBytes{}.u16(type).u32(12 + items.size()).u16(0).u32(count).bytes(items);
}

/// Of BX: a pose, a tool out of the volume, one that is disabled.
inline WireBytes bxSample()
{
    return WireBytes{}
        .u8(3)
        .bytes(WireBytes{}.u8(0x0A).u8(1).bytes(wirePose()).u32(0x31).u32(900))
        .bytes(WireBytes{}.u8(0x0B).u8(2).u32(0x71).u32(900))
        .bytes(WireBytes{}.u8(0x0C).u8(4))
        .u16(0x0002);
}

/// Of BX with the states and positions of markers, and a stray.
inline WireBytes bxMarkerSample()
{
    WireBytes sample = WireBytes{}.u8(1).u8(1).u8(2).u32(0x31).u32(7);
    for (int i = 0; i < 11; ++i)
        sample.u8(0x33);
    sample.u8(2).u8(0x02).real(1.0F).real(2.0F).real(3.0F).real(4.0F).real(5.0F).real(6.0F);
    return sample.u8(1).u8(0).real(7.0F).real(8.0F).real(9.0F).u16(0);
}

/// Of BX2: a frame with two poses, a tool of too few markers, markers of a tool and a stray, and
/// buttons.
inline WireBytes bx2Sample()
{
    const WireBytes tools = WireBytes{}
                                .bytes(WireBytes{}.u16(3).u16(0).bytes(wirePose()))
                                .bytes(WireBytes{}.u16(4).u16(0x0003).bytes(wirePose()))
                                .bytes(WireBytes{}.u16(5).u16(0x010D));
    const WireBytes marker = WireBytes{}.u8(0).u8(0).u16(0).real(1.0F).real(2.0F).real(3.0F);
    const WireBytes markers =
        WireBytes{}.u16(3).u16(1).bytes(marker).u16(0xFFFF).u16(1).bytes(marker);
    const WireBytes parts = WireBytes{}
                                .u16(1)
                                .u16(3)
                                .bytes(bx2Component(2, 3, tools))
                                .bytes(bx2Component(3, 2, markers))
                                .bytes(bx2Component(4, 1, WireBytes{}.u16(3).u16(1).u8(1)));
    const WireBytes frame =
        WireBytes{}.u8(1).u8(3).u16(0).u32(77).u32(5).u32(250000000).bytes(parts);
    return WireBytes{}.u16(1).u16(1).bytes(bx2Component(1, 1, frame));
}

/// One or more of each reader, all of which are read without a fault.
inline std::vector<NdiSample> ndiSamples()
{
    using Reader = NdiSample::Reader;
    const std::string stream =
        "RESETBE6F\r" + kRecordedBxHeader + kRecordedBx + kRecordedBxChecksum + "OKAYA896\r";
    return {
        {Reader::Tx, kNdiPoses, kRecordedTx},
        {Reader::Tx, kNdiPoses | kNdiMarkerStates,
         "0201MISSING000000310000040D0200000000000000000000\n"
         "02+05036+04469+04825+05601-005056+010437-202772+00180000000310000040C0000000000030000300"
         "003\n0000"},
        {Reader::Tx, kNdiPoses | kNdiSingleStray,
         "0201MISSING000000310000037700\n"
         "02+04985+04691+04244+05926-007836+009627-209044+00509000000310000037600\n0000"},
        {Reader::Tx, kNdiStrays,
         "0201\n02\n030+015360+030698-223261+015173+022199-225596+007159+026725-2274150000"},
        {Reader::Bx, kNdiPoses, bxSample().text()},
        {Reader::Bx, kNdiPoses, kRecordedBx},
        {Reader::Bx, kNdiPoses | kNdiMarkerStates | kNdiMarkerPositions | kNdiStrays,
         bxMarkerSample().text()},
        {Reader::Bx2, 0, bx2Sample().text()},
        {Reader::Stream, 0, stream},
        {Reader::Stream, 6, stream},
        {Reader::Recording, 0,
         "recv:0001 = RESETBE6F\nsent:0002 = TX:0001031A\n"
         "recv:0002 = 0101MISSING00000031000003A3\n00005A49\n"},
        {Reader::Recording, 0,
         "1127242654.20 : (INFO) 41. command[12] BX:0001C26D\\x0D\n"
         "1127242654.21 : (INFO) 41. receive[6] \\xC4\\xA5\\x17\\x00\"\\xE3\n"
         "1127242654.22 : (INFO) 41. receive[25] "
         "\\x02\\x01\\x021\\x00\\x00\\x00\\x00\\x00\\x00\\x00"
         "\\x02\\x021\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\xB17\n"}};
}

} // namespace carina::test
