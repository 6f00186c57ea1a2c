#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Detail/VtkXml.hpp>
#include <Cutwater/Io/VtkFiles.hpp>

namespace cutwater {

template <std::floating_point T>
void writePvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
               std::span<const VtkArray> arrays) {
  require(!pieces.empty(), "writePvtu: need at least one piece");
  detail::checkVtkNames("writePvtu", arrays);
  detail::VtkXml xml("PUnstructuredGrid", {{"GhostLevel", "0"}});
  xml.empty("PPointData");
  xml.declarations("PCellData", arrays);
  xml.open("PPoints");
  xml.declaration("Points", detail::vtkType<T>(), 3);
  xml.close("PPoints");
  for (const auto& piece : pieces) xml.empty("Piece", {{"Source", piece}});
  OutputFile file(path);
  file.write(xml.finishedAlone());
  file.commit();
}

template void writePvtu<float>(const std::filesystem::path&, std::span<const std::string>,
                               std::span<const VtkArray>);
template void writePvtu<double>(const std::filesystem::path&, std::span<const std::string>,
                                std::span<const VtkArray>);

}  // namespace cutwater
