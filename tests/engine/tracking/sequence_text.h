#pragma once

#include <string>
#include <vector>

namespace carina::test
{

/// The text of a sequence file, written field by field.
class SequenceText
{
public:
    /// Begins the next frame, at a time in seconds.
    SequenceText& frame(const std::string& timestamp)
    {
        ++m_frames;
        return field("Timestamp", timestamp);
    }

    /// Any field of the current frame.
    SequenceText& field(const std::string& name, const std::string& value)
    {
        const std::string digits = std::to_string(m_frames - 1);
        const std::string padded = std::string(4 - digits.size(), '0') + digits;
        m_fields += "Seq_Frame" + padded + "_" + name + " = " + value + "\n";
        return *this;
    }

    /// A tool's pose in the current frame: 16 numbers, millimetres.
    SequenceText& tool(const std::string& name, const std::string& matrix,
                       const std::string& status = "OK")
    {
        field(name + "ToTrackerTransform", matrix);
        return field(name + "ToTrackerTransformStatus", status);
    }

    /// A tool's pose without a turn, millimetres.
    SequenceText& toolAt(const std::string& name, const std::string& x, const std::string& y,
                         const std::string& z)
    {
        return tool(name, "1 0 0 " + x + " 0 1 0 " + y + " 0 0 1 " + z + " 0 0 0 1");
    }

    [[nodiscard]] std::string text() const { return textClaiming(std::to_string(m_frames)); }

    /// The text with another number of frames in its DimSize.
    [[nodiscard]] std::string textClaiming(const std::string& frames) const
    {
        return "ObjectType = Image\nNDims = 3\nDimSize = 0 0 " + frames + "      \n" + m_fields
               + "ElementDataFile = LOCAL\n";
    }

private:
    std::string m_fields;
    int m_frames = 0;
};

} // namespace carina::test
