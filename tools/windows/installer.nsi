; The installer for one user: no administrator, no registry of the machine. tools/package-windows gives VERSION, TREE, OUT.
Target amd64-unicode
Name "glibra ${VERSION}"
OutFile "${OUT}"
RequestExecutionLevel user
InstallDir "$LOCALAPPDATA\Programs\glibra"
InstallDirRegKey HKCU "Software\glibra" "Folder"
SetCompressor /SOLID lzma
SetCompressorDictSize 32 ; the programs have much in common
ManifestDPIAware true
BrandingText "glibra ${VERSION}"
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "glibra"
VIAddVersionKey ProductVersion "${VERSION}"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey FileDescription "Installs glibra, which runs GLIB shader scenes"
VIAddVersionKey LegalCopyright "see LICENSE"

!include "MUI2.nsh"
!include "FileFunc.nsh"
!include "StrFunc.nsh"
${StrStr}
${UnStrRep}
!insertmacro MUI_PAGE_COMPONENTS
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"

!define UNINSTALL "Software\Microsoft\Windows\CurrentVersion\Uninstall\glibra"

Section "glibra (required)"
    SectionIn RO
    SetOutPath "$INSTDIR"
    File /r "${TREE}/*"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    WriteRegStr HKCU "Software\glibra" "Folder" "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "glibra ${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\glibra-view.exe"
    WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
    WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
    ${GetSize} "$INSTDIR" "/S=0K" $0 $1 $2
    WriteRegDWORD HKCU "${UNINSTALL}" "EstimatedSize" $0
SectionEnd

Section "Start menu"
    CreateShortcut "$SMPROGRAMS\glibra.lnk" "$INSTDIR\glibra-view.exe"
SectionEnd

Section "Open .glib files with glibra"
    WriteRegStr HKCU "Software\Classes\glibra.scene" "" "GLIB shader scene"
    WriteRegStr HKCU "Software\Classes\glibra.scene\DefaultIcon" "" "$INSTDIR\glibra-view.exe,0"
    WriteRegStr HKCU "Software\Classes\glibra.scene\shell\open\command" "" '"$INSTDIR\glibra-view.exe" "%1"'
    WriteRegStr HKCU "Software\Classes\.glib" "" "glibra.scene"
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, i 0, i 0)'
SectionEnd

Section /o "glibra in PATH, for terminals"
    ReadRegStr $0 HKCU "Environment" "Path"
    ${StrStr} $1 ";$0;" ";$INSTDIR;"
    StrCmp $1 "" 0 done
    StrCmp $0 "" 0 +3
    WriteRegExpandStr HKCU "Environment" "Path" "$INSTDIR"
    Goto changed
    WriteRegExpandStr HKCU "Environment" "Path" "$0;$INSTDIR"
changed:
    SendMessage ${HWND_BROADCAST} ${WM_SETTINGCHANGE} 0 "STR:Environment" /TIMEOUT=5000
done:
SectionEnd

Section "Uninstall"
    ReadRegStr $0 HKCU "Environment" "Path"
    ${UnStrRep} $1 ";$0;" ";$INSTDIR;" ";"
    StrCmp $1 ";$0;" unchanged
    StrCpy $1 $1 -1 1  ; without the semicolons that were added
    WriteRegExpandStr HKCU "Environment" "Path" "$1"
    SendMessage ${HWND_BROADCAST} ${WM_SETTINGCHANGE} 0 "STR:Environment" /TIMEOUT=5000
unchanged:
    ReadRegStr $0 HKCU "Software\Classes\.glib" ""
    StrCmp $0 "glibra.scene" 0 +2
    DeleteRegKey HKCU "Software\Classes\.glib"
    DeleteRegKey HKCU "Software\Classes\glibra.scene"
    DeleteRegKey HKCU "${UNINSTALL}"
    DeleteRegKey HKCU "Software\glibra"
    Delete "$SMPROGRAMS\glibra.lnk"
    ; Only what the installer has brought: a folder that somebody chose may have files of others.
    !include "${LIST}"
    Delete "$INSTDIR\uninstall.exe"
    RMDir "$INSTDIR"
SectionEnd
