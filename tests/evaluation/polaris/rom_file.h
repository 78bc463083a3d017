#pragma once

#include "engine/geometry/vec.h"

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace carina::test
{

/// What the bytes of a .rom file say, at the places of the table of NDI's tool files.
struct RomFile {
    std::vector<Vec3> markers_mm{{0, 0, 0}, {60, 0, 0}, {0, 85, 0}, {-40, -45, 15}};
    Vec3 normal = Vec3::Zero(); ///< of all of them
    unsigned fewest = 3;
    std::string maker = "Test";
    std::string partNumber = "probe";

    [[nodiscard]] std::string bytes() const
    {
        std::string rom(752, '\0');
        const auto put = [&rom](std::size_t at, const std::string& text) {
            rom.replace(at, text.size(), text);
        };
        const auto word = [&put](std::size_t at, std::uint32_t value) {
            for (std::size_t i = 0; i < 4; ++i)
                put(at + i, std::string(1, char(value >> (8 * i) & 0xFFU)));
        };
        const auto vector = [&word](std::size_t at, const Vec3& v) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                word(at + 4 * axis, std::bit_cast<std::uint32_t>(float(v[Eigen::Index(axis)])));
        };
        put(0, "NDI");
        word(8, 1);
        word(12, 0x02000001); // a pointer, of sub type 1
        word(16, 3);          // revision
        word(20, 0x34802401); // number and date
        word(24, 60);         // degrees
        word(28, std::uint32_t(markers_mm.size()));
        word(32, fewest);
        word(36, std::bit_cast<std::uint32_t>(0.75F));
        word(64, std::bit_cast<std::uint32_t>(10.0F));
        for (std::size_t i = 0; i < markers_mm.size(); ++i) {
            vector(72 + 12 * i, markers_mm[i]);
            vector(312 + 12 * i, normal);
        }
        put(580, maker);
        put(592, partNumber);
        std::uint32_t sum = 0;
        for (std::size_t i = 6; i < rom.size(); ++i)
            sum += static_cast<unsigned char>(rom[i]);
        put(4, std::string{char(sum & 0xFFU), char(sum >> 8U & 0xFFU)});
        return rom;
    }
};

} // namespace carina::test
